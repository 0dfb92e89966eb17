#pragma once
#include <optional>

#include "scene/mesh.h"
#include "scene/object.h"

namespace ps {

/// A model and an instance of it that put the same triangles, with the same fronts, into the world.
struct Unmirrored {
  Mesh mesh;
  Instance instance;
};

/// Without negative scale factors: for the listings, which find fronts by the order of the vertices as the camera sees
/// them, and only turn their normals. The model is mirrored instead. nullopt for an instance that mirrors no axis.
std::optional<Unmirrored> unmirrored(const Mesh& mesh, const Instance& instance);

}  // namespace ps
