#pragma once
#include <cstdint>

#include "base/block_store.h"
#include "math/vec.h"
#include "raster/setup/draw_list.h"

namespace ps::raster {

/// A vertex's place on the canvas (FixedPoint), and in `outside` one bit for each plane of RasterInputs::planes that it
/// lies behind; no_place where it has no place in fixed point at all.
struct VertexPlace {
  static constexpr std::uint32_t no_place = 1u << 31;
  std::int32_t column = 0, row = 0;
  std::uint32_t outside = 0;
  std::uint32_t unused = 0;
};

/// An object's vertices after the vertex stage. The fourth scalar only makes them easy to read for the fast path.
template <class Real>
struct VertexBuffer {
  BlockVector<Vec4<Real>> camera;   ///< camera space; from the fast path with 1 / z
  BlockVector<Vec4<Real>> world;    ///< empty unless shading needs it; from the fast path with 1 / z
  BlockVector<Vec4<Real>> normals;  ///< world space, length 1; empty unless shading needs them
  BlockVector<VertexPlace> places;  ///< only from the fast path, and while one pixel is inspected
  /// Only from the fast path, where shading needs both and each vertex has its own normal: of every vertex the normal
  /// and then the world position, both divided by z, with 1 / z as the last number. In place of `world` and `normals`.
  BlockVector<Vec4<Real>> lit;

  /// Where few triangles ask (while one pixel is inspected, and of the fast path's those that something cuts), their
  /// vertices' world positions and normals are made from these when they are asked for, where shading needs them.
  const DrawObject* world_of = nullptr;
  const DrawObject* normals_of = nullptr;

  bool has_normals() const { return !normals.empty() || normals_of; }
};

}  // namespace ps::raster
