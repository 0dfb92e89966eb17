#pragma once
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/scene.h"

namespace ps::gui {

/// Ways to move a camera. The frame is turned as a whole, so that a frame that is not orthonormal keeps its shape.
/// Angles are radians. Nothing depends on handedness: "right" and "up" are where the frame's own axes point.

/// Turns the camera on the spot: `to_right` about `world_up`, then `upwards` about its own right axis, never past
/// straight up or down.
Camera turned(const Camera& camera, double to_right, double upwards, const Vec3d& world_up);
/// Carries the camera around `pivot`, as if the scene were turned by hand: it keeps its distance and what it aims at.
Camera orbited(const Camera& camera, double to_right, double upwards, const Vec3d& world_up, const Vec3d& pivot);
/// Moves the camera along its own axes, in world units.
Camera moved(const Camera& camera, double right, double up, double forward);

/// The centre of the scene without spheres so large that they are its ground; for an empty scene, the point one unit
/// ahead of the camera.
Vec3d scene_centre(const Scene& scene);
/// A length in world units that suits steps in this scene: the distance from the camera to the scene's centre.
double scene_reach(const Scene& scene, const Camera& camera);

/// Moves a point light by world units along the camera's axes; turns a directional light's direction likewise, with
/// its length taken as the reach. Ambient light stays.
Light moved_light(const Light& light, const Camera& camera, double right, double up, double forward, double reach);

}  // namespace ps::gui
