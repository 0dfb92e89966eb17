#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "raster/fast/assembly.h"

namespace ps::raster {

/// A triangle that was nearer somewhere in the tile, when it came, than all before.
struct TileTriangle {
  const FastTriangle* triangle = nullptr;
  const FastPart* part = nullptr;

  std::uint32_t surface() const { return triangle->surface; }
};

/// A fragment that a nearer one replaced.
struct ReplacedFragment {
  float inverse_z = 0;
  std::uint32_t id = 0;
  std::uint32_t at = 0;  ///< sample in the tile
};

/// Visibility in one tile so far: of each sample the nearest fragment's depth and triangle. All else about it is
/// found out again when all triangles have been drawn, so that little memory is touched for hidden fragments. Rows are
/// fast_tile samples apart, also in the narrower tiles at the edges of the picture.
struct TileFragments {
  static constexpr std::size_t samples = std::size_t{fast_tile} * fast_tile;
  static constexpr std::uint32_t none = 0xffffffff;
  alignas(64) std::array<float, samples> inverse_z;   ///< the depth buffer
  alignas(64) std::array<std::uint32_t, samples> id;  ///< index into `triangles`
  BlockVector<TileTriangle> triangles;                ///< with room for every entry of the tile's lists
  std::uint32_t triangle_count = 0;
  std::uint64_t fragments = 0;
  std::vector<std::uint64_t> passed;       ///< the depth test, for each surface
  std::vector<ReplacedFragment> replaced;  ///< where they are kept
  bool keep_replaced = false;

  /// Forgets what the last tile held. `entries` is the length of all lists together.
  void start(std::size_t entries, std::size_t surfaces);
};

/// Coverage and depth of one part's triangles in the tile `rect`, in order. Repeats EdgeFunctions, make_fragment and
/// the depth test of draw_primitives.cpp to the last bit.
using CoverTile = void (*)(const TileRect& rect, const FastPart& part, std::span<const std::uint32_t> entries,
                           TileFragments& tile);
CoverTile cover_kernel(Simd simd);

}  // namespace ps::raster
