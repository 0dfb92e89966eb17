#pragma once
#include <vector>

#include "raster/base/vertex_buffer.h"
#include "raster/fast/packed_textures.h"
#include "raster/fast/shade_batch.h"
#include "raster/fast/tile.h"

namespace ps::raster {

/// How the fragments of one surface are shaded, and where a triangle's numbers lie in its row: three vertices one after
/// the other, then what the triangle has once. Every slot begins at a multiple of 4.
struct FastSurface {
  BatchShading shading;  ///< its attributes are the row
  int corner_size = 0;   ///< scalars of a vertex
  int row_size = 0;      ///< scalars in all
  bool textured = false;
};

/// For every surface of the picture.
std::vector<FastSurface> fast_surfaces(const RasterInputs<float>& inputs, const PackedTextures& textures);

/// What the triangles seen in a tile carry, made when it is first asked for. Keeps its memory from tile to tile.
class AttributeRows {
 public:
  AttributeRows(const RasterInputs<float>& inputs, const std::vector<VertexBuffer<float>>& vertices,
                const std::vector<FastSurface>& surfaces)
      : inputs_(inputs), vertices_(vertices), surfaces_(surfaces) {}

  /// The rows will be those of this tile. Of many triangles it makes them for all that is seen, in drawing order, in
  /// which vertices mostly follow each other in memory.
  void start(const TileFragments& tile);
  /// Where the row of the tile's triangle `id` begins in numbers(), which may move when a row is made.
  std::uint32_t row_of(std::uint32_t id) {
    const std::uint32_t begin = begin_[id];
    return begin < seen ? begin : make_row(id);
  }
  const float* numbers() const { return numbers_.data(); }
  const std::vector<FastSurface>& surfaces() const { return surfaces_; }

 private:
  static constexpr std::uint32_t missing = 0xffffffff;
  static constexpr std::uint32_t seen = missing - 1;  ///< and still missing

  std::uint32_t make_row(std::uint32_t id);
  void fetch(const TileTriangle& triangle) const;
  void fetch_vertices(const TileTriangle& triangle) const;
  void fill_piece(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_from_vertices(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_lit(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_corners(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_uvs(const TileTriangle& triangle, const FastSurface& how, float* row) const;
  void fill_steps(const TileTriangle& triangle, const FastSurface& how, float* row) const;

  const RasterInputs<float>& inputs_;
  const std::vector<VertexBuffer<float>>& vertices_;
  const std::vector<FastSurface>& surfaces_;
  const TileFragments* tile_ = nullptr;
  std::vector<std::uint32_t> begin_;  ///< of each of the tile's triangles
  BlockVector<float> numbers_;
  std::size_t used_ = 0;  ///< of them
};

}  // namespace ps::raster
