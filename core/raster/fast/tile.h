#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "raster/fast/assembly.h"
#include "raster/shade_batch.h"

namespace ps::raster {

/// A triangle with a fragment in the tile that was nearer, when it came, than all before.
struct TileTriangle {
  const FastTriangle* triangle = nullptr;
  const FastPart* part = nullptr;
};

/// A fragment that a nearer one replaced.
struct ReplacedFragment {
  std::array<float, 3> weights{};
  float inverse_z = 0;
  std::uint32_t id = 0;
};

/// What is seen in one tile so far: of each sample the nearest fragment, by which shading begins when all triangles
/// have been drawn. Rows are fast_tile samples apart, also in the narrower tiles at the edges of the picture.
struct TileFragments {
  static constexpr std::size_t samples = std::size_t{fast_tile} * fast_tile;
  static constexpr std::size_t room = samples + 16;  ///< whole vectors are read
  static constexpr std::uint32_t none = 0xffffffff;
  using Plane = std::array<float, room>;
  alignas(64) Plane inverse_z;                     ///< the depth buffer
  alignas(64) std::array<Plane, 3> weights;        ///< on the screen
  alignas(64) std::array<std::uint32_t, room> id;  ///< index into `triangles`
  BlockVector<TileTriangle> triangles;             ///< with room for every entry of the tile's lists
  std::uint32_t triangle_count = 0;
  std::uint64_t fragments = 0;
  std::vector<std::uint64_t> passed;       ///< the depth test, for each surface
  std::vector<ReplacedFragment> replaced;  ///< where they are kept
  bool keep_replaced = false;

  /// Forgets what the last tile held. `entries` is the length of all lists together.
  void start(std::size_t entries, std::size_t surfaces);
};

struct TileKernels {
  /// Coverage and depth of one part's triangles in the tile `rect`, in order. Repeats TriangleEdges, make_fragment and
  /// the depth test of draw_primitives.cpp to the last bit.
  void (*cover)(const CoverageGrid& grid, const TileRect& rect, const FastPart& part,
                std::span<const std::uint32_t> entries, TileFragments& tile) = nullptr;
  /// Appends the fragments of one row of the tile to the batch, their ids in place of rows, and gives the background's
  /// colour to samples without one. `pixels` is the picture's first row, `width` its length.
  void (*collect)(const TileFragments& tile, const TileRect& rect, int row, const Vec3f& background, Vec3f* pixels,
                  int width, ShadeBatch& batch) = nullptr;
  /// Writes the batch's colours to the picture; whether any is NaN.
  bool (*write)(const ShadeBatch& batch, Vec3f* pixels) = nullptr;
};
TileKernels tile_kernels(Simd simd);

}  // namespace ps::raster
