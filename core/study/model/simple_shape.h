#pragma once
#include <optional>

#include "scene/scene.h"

namespace ps::model {

/// The box or the rectangle whose surface the triangles of a model cover exactly once, or nullopt: the model has
/// another shape, several materials, a picture on its surface, or vertex normals that round it off. Lengths may differ
/// by a billionth of the model's size.
std::optional<Solid> simple_shape(const Scene& scene, const Object& object);

}  // namespace ps::model
