#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "accel/box.h"
#include "math/unit.h"
#include "scene/mesh.h"
#include "scene/object.h"
#include "scene/world.h"

namespace ps {

/// World-space vertices.
template <class Real>
struct TracedTriangle {
  Vec3<Real> a{0}, b{0}, c{0};
  std::int32_t attributes = -1;  ///< index into TracedGeometry::attributes; -1 = none
};

template <class Real>
struct TriangleAttributes {
  std::array<Vec3<Real>, 3> normals{};  ///< world space, unit length
  std::array<Vec2<Real>, 3> uvs{};
  bool has_normals = false;
  bool has_uvs = false;
};

/// An instance whose triangles are placed in the world one by one, whenever a ray asks for them, by the very operations
/// that unfolding does beforehand.
struct PlacedInstance {
  std::int32_t object = -1;
  std::uint32_t mesh = 0;   ///< index into TracedGeometry::meshes
  std::uint32_t first = 0;  ///< number of its first triangle
  bool front_only = false;
  bool mirrored = false;                  ///< mirrors(transform)
  bool in_double = false;                 ///< some of its triangles are tested in double
  std::optional<std::uint32_t> material;  ///< for all of its triangles
  Transform transform;
  Mat3d normals{1.0};  ///< takes vertex normals to the world
  Box<double> box;     ///< of its triangles in the world, as rays see them
};

/// A vertex in the world, as rays see it.
template <class Real>
inline Vec3<Real> placed_corner(const Transform& transform, const Vec3d& position) {
  return Vec3<Real>(to_world(transform, position));
}

/// Its `attributes` say no more than whether there are some.
template <class Real>
inline TracedTriangle<Real> placed_triangle(const PlacedInstance& placed, const Mesh& mesh, std::uint32_t triangle) {
  const MeshTriangle& corners = mesh.triangles[triangle];
  const auto corner = [&](std::size_t k) {
    return placed_corner<Real>(placed.transform, mesh.positions[corners.position[k]]);
  };
  const bool bare = (corners.normal[0] < 0 || corners.normal[1] < 0 || corners.normal[2] < 0) &&
                    (corners.uv[0] < 0 || corners.uv[1] < 0 || corners.uv[2] < 0);
  return {corner(0), corner(1), corner(2), bare ? -1 : 0};
}

/// `world_normal(i)` is vertex normal i in the world.
template <class Real, class WorldNormal>
inline TriangleAttributes<Real> placed_attributes(const Mesh& mesh, const MeshTriangle& corners,
                                                  WorldNormal&& world_normal) {
  TriangleAttributes<Real> attributes;
  attributes.has_normals = corners.normal[0] >= 0 && corners.normal[1] >= 0 && corners.normal[2] >= 0;
  attributes.has_uvs = corners.uv[0] >= 0 && corners.uv[1] >= 0 && corners.uv[2] >= 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (attributes.has_normals) attributes.normals[k] = Vec3<Real>(world_normal(corners.normal[k]));
    if (attributes.has_uvs) attributes.uvs[k] = Vec2<Real>(mesh.uvs.at(static_cast<std::size_t>(corners.uv[k])));
  }
  return attributes;
}

/// Twice the area is not 0: nothing can hit the others. Products of floats are exact in double.
template <class Real>
inline bool has_area(const TracedTriangle<Real>& triangle) {
  return largest_component(triangle_normal(Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c))) > 0;
}

/// Is the triangle so large, for a viewport at distance `near_plane`, that its vertices' own rounding is seen, or so
/// small that products of its edges leave the range of float? Then float cannot test it, and double does.
inline bool asks_for_double(const TracedTriangle<float>& triangle, double near_plane) {
  constexpr float least = 0x1p-56f;
  const float extent = std::max(largest_component(triangle.b - triangle.a), largest_component(triangle.c - triangle.a));
  return extent < least || static_cast<double>(extent) > 0x1p16 * near_plane;
}
inline bool asks_for_double(const TracedTriangle<double>&, double) { return false; }

}  // namespace ps
