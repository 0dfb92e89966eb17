#pragma once
#include <array>
#include <optional>
#include <vector>

#include "inspect/space_image.h"
#include "inspect/space_model.h"

/// The parts that build_space() puts together.
namespace ps {

/// What the parts share.
struct SpaceInputs {
  const Scene& scene;
  const View& view;
  const Settings& settings;
  const PixelStory* story = nullptr;
  SpaceImage image;
  SpaceBounds bounds;
};

/// How far a line towards a directional light goes, of the bounds' radius.
inline constexpr double sunward_share = 0.75;

/// Around eye, image, lights, and objects that are not ground.
SpaceBounds space_bounds(const SpaceInputs& inputs);

/// For each object whether it is a sphere so large that its part in sight is a plane.
std::vector<bool> ground_objects(const SpaceInputs& inputs);

/// Frustum, image with grid and picked pixel, near plane.
void add_camera(const SpaceInputs& inputs, SpaceModel& model);
void add_lights(const SpaceInputs& inputs, SpaceModel& model);
/// Silhouettes and shadow volumes, or the reach of the shadow maps, where the rasterizer uses them.
void add_shadow_methods(const SpaceInputs& inputs, SpaceModel& model);
/// Rays, hits, normals, hit triangles and nodes of a ray tracer's story.
void add_rays(const SpaceInputs& inputs, SpaceModel& model);
/// Triangles, their projections and shading of a rasterizer's story.
void add_fragments(const SpaceInputs& inputs, SpaceModel& model);

/// A surface point with its normal as an arrow, whose length is `normal_length` times that of the normal.
void add_normal(SpaceKind kind, const Vec3d& point, const Vec3d& normal, const SpaceItem& like,
                const SpaceInputs& inputs, SpaceModel& model);
/// World units for a normal of length 1.
double normal_length(const SpaceBounds& bounds);
/// The triangle and the three areas into which the point with these weights divides it.
void add_triangle(const std::array<Vec3d, 3>& corners, const std::array<double, 3>& weights, const SpaceItem& like,
                  SpaceModel& model);
/// A way along three great circles of a sphere, one around each axis.
std::vector<Vec3d> sphere_outline(const Vec3d& centre, double radius);
/// World-space vertices of a triangle that the scene holds; none for spheres and unknown ids.
std::optional<std::array<Vec3d, 3>> world_triangle(const Scene& scene, const PixelId& id);

}  // namespace ps
