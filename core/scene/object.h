#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "math/vec.h"
#include "scene/solid.h"

namespace ps {

/// A sphere in world space.
struct Sphere {
  Vec3d centre{0, 0, 0};
  double radius = 1;
  std::uint32_t material = 0;  ///< index into Scene::materials
  bool operator==(const Sphere&) const = default;
};

/// Model to world: scale, then rotation, then translation (CGFS ch. 10). `rotation` is used as given.
struct Transform {
  Vec3d scale{1, 1, 1};
  Mat3d rotation{1.0};
  Vec3d translation{0, 0, 0};
  bool operator==(const Transform&) const = default;
};

/// A mesh placed in the world.
struct Instance {
  std::uint32_t mesh = 0;  ///< index into Geometry::meshes
  Transform transform;
  std::optional<std::uint32_t> material;  ///< index into Scene::materials; overrides all of the mesh's materials
  Sides sides = Sides::two;               ///< front: rays pass through triangles seen from behind (CGPP 15.4)
  bool operator==(const Instance&) const = default;
};

/// One thing in the scene. Objects keep the order of the scene file; ids in pictures are indices into that order.
struct Object {
  std::string name;
  std::variant<Sphere, Instance, Solid, Csg> shape;
  bool dynamic = false;  ///< may move while others do not; environment maps can leave it out (CGFS ch. 15)
  bool operator==(const Object&) const = default;
};

}  // namespace ps
