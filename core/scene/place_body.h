#pragma once
#include "scene/material.h"
#include "scene/object.h"

namespace ps {

/// A sphere, box or cylinder where the groups around it put it. Under a map that keeps shapes (a translation, a
/// rotation, one scale for all directions, mirroring) it is the same kind of body with other numbers, exactly. Where
/// the map stretches it, or where a picture on its surface has to turn with it, the body keeps its numbers and the map
/// becomes its Solid::place, as for parts of CSG trees (CGPP ex. 15.7b).
decltype(Object::shape) placed_body(const Solid& body, const PartPlace& around, const Material& material);

}  // namespace ps
