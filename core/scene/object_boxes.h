#pragma once
#include <vector>

#include "scene/form_frame.h"
#include "scene/scene.h"

namespace ps {

/// A box around each object of the world; not bounded where an object has none. Of a plane it is the point that the
/// plane is given by, of a model it is around the vertices that its triangles use.
std::vector<FormBox> boxes_of_objects(const Geometry& geometry);

void include_point(FormBox& box, const Vec3d& point);
/// From a point to a box; 0 within.
double distance_to(const FormBox& box, const Vec3d& point);

}  // namespace ps
