#pragma once
#include <vector>

#include "raster/fast/tile.h"

namespace ps::raster {

/// How the fragments of one surface are shaded, and where a triangle's numbers lie in its row (BatchShading::row_size).
struct FastSurface {
  BatchShading shading;
  int corner_size = 0;  ///< scalars of a corner
  bool textured = false;
};

/// For every surface of the pass.
std::vector<FastSurface> fast_surfaces(const Pass<float>& pass);

/// Shades what the tile holds and writes it to the picture. Keeps its memory from tile to tile.
class TileResolver {
 public:
  TileResolver(const Pass<float>& pass, const std::vector<VertexBuffer<float>>& vertices,
               const std::vector<FastSurface>& surfaces)
      : pass_(pass), vertices_(vertices), surfaces_(surfaces), kernels_(tile_kernels(pass.settings.simd)) {}

  /// Adds what the clear path would have counted.
  void resolve(const TileFragments& tile, const TileRect& rect, Frame& frame, Counters& counters);

 private:
  void shade_replaced(const TileFragments& tile);
  void shade_fragments(const TileFragments& tile);
  std::int32_t row_of(const TileTriangle& triangle, std::uint32_t id);
  void fill_row(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_corners(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void count(const TileFragments& tile, Counters& counters) const;

  const Pass<float>& pass_;
  const std::vector<VertexBuffer<float>>& vertices_;
  const std::vector<FastSurface>& surfaces_;
  TileKernels kernels_;
  std::vector<std::int32_t> rows_;  ///< of each of the tile's triangles, -1 = not made yet
  BlockVector<float> numbers_;      ///< the rows' contents
  std::size_t used_ = 0;            ///< of them
  ShadeBatch batch_;
};

}  // namespace ps::raster
