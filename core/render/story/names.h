#pragma once
#include <string>

#include "frame/frame.h"
#include "record/events.h"
#include "scene/scene.h"

namespace ps {

/// How stories and tables name objects, lights and triangles of a scene. All indices count from 0: an object's among
/// those of its kind, a light's in Scene::lights and a triangle's in the model's list. The triangle picture shows the
/// same numbers.

/// "sphere 2 (green)", "cube 1", or the object's own name where the scene file gives one. `object` is an index into
/// Geometry::objects; one that the scene does not have is named by its number.
std::string object_name(const Scene& scene, int object);
/// The object, or "triangle 7 of cube 1" where it is made of triangles: "triangle 7 of robot (Head)" where its model's
/// file has names for its parts. The object alone for an id without a triangle; "nothing" for an empty id.
std::string primitive_name(const Scene& scene, const PixelId& id);
/// "an edge of triangle 7 of cube 1", "a vertex of ..." or "a line", which lies on the canvas.
std::string line_name(const Scene& scene, const LineEvent& line);
/// "light 2 (point)"; `light` is an index into Scene::lights.
std::string light_name(const Scene& scene, int light);

}  // namespace ps
