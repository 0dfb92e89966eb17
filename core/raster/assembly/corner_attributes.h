#pragma once
#include <array>
#include <cmath>

#include "math/unit.h"
#include "raster/base/raster_inputs.h"
#include "raster/base/vertex_buffer.h"
#include "record/recorder.h"

namespace ps::raster {

/// Most scalars that one vertex can carry: normal, position, uv, tangents, light and extra.
inline constexpr std::size_t max_attributes = 20;

/// The scalars of one vertex, in the order of its surface's layout.
template <class Real>
using CornerAttributes = std::array<Real, max_attributes>;

/// One triangle of a mesh with what the vertex stage made of its vertices.
template <class Real>
struct CornerSource {
  const Mesh* mesh = nullptr;
  const MeshTriangle* triangle = nullptr;
  const VertexBuffer<Real>* vertices = nullptr;
  Vec3<Real> face_normal{0, 0, 0};  ///< world space, length 1

  /// Vertex `k`'s normal as the option `normals` asks.
  Vec3<Real> normal(std::size_t k, Normals normals) const {
    const auto index = triangle->normal[k];
    if (normals == Normals::triangle || index < 0 || !vertices->has_normals()) return face_normal;
    const auto n = static_cast<std::size_t>(index);
    return vertices->normals_of ? Vec3<Real>(vertices->normals_of->world_normal(n)) : Vec3<Real>(vertices->normals[n]);
  }
  Vec3<Real> position(std::size_t k) const {
    const std::size_t p = triangle->position[k];
    return vertices->world_of ? Vec3<Real>(vertices->world_of->world(mesh->positions[p]))
                              : Vec3<Real>(vertices->world[p]);
  }
};

/// Whether anything that shades a triangle of the surface reads the triangle's own normal: where vertices have none.
template <class Real>
inline bool reads_face_normal(const RasterInputs<Real>& inputs, const Surface<Real>& surface,
                              const CornerSource<Real>& source) {
  const AttributeLayout& layout = surface.layout;
  if (!layout.lit && !layout.shading_normal) return false;
  if (layout.shading_normal && layout.normal == AttributeLayout::absent) return true;
  const auto& normal = source.triangle->normal;
  const bool own = normal[0] >= 0 && normal[1] >= 0 && normal[2] >= 0 && source.vertices->has_normals();
  return inputs.settings.normals == Normals::triangle || !own;
}

/// The triangle's own normal: world space, length 1.
template <class Real>
inline Vec3<Real> face_normal(const DrawObject& object, const MeshTriangle& triangle) {
  const auto world = [&](std::size_t k) { return object.world(object.mesh->positions[triangle.position[k]]); };
  const Vec3d normal = unit_of(triangle_normal(world(0), world(1), world(2)));
  return Vec3<Real>(object.mirrored ? -normal : normal);
}

/// Fills in what the layout asks for; Gouraud shading evaluates the lighting at the vertices here.
template <class Real>
std::array<CornerAttributes<Real>, 3> corner_attributes(const RasterInputs<Real>& inputs, const Surface<Real>& surface,
                                                        const CornerSource<Real>& source, CountingRecorder& recorder);

/// Flat shading: the light at the centre of the triangle, with the mean of its vertexs' normals.
template <class Real>
struct FlatPoint {
  Vec3<Real> position{0, 0, 0};
  Vec3<Real> normal{0, 0, 0};
};
template <class Real>
FlatPoint<Real> flat_point(const CornerSource<Real>& source, Normals normals);

}  // namespace ps::raster
