#pragma once
#include "raster/fast/attribute_rows.h"

namespace ps::raster {

/// What shading a tile needs to know, and what it finds out.
struct ResolveTask {
  const TileFragments& tile;
  TileRect rect;
  AttributeRows& rows;
  Vec3f background{0, 0, 0};
  Vec3f* pixels = nullptr;   ///< of the picture, row by row
  int width = 0;             ///< of the picture
  std::uint64_t texels = 0;  ///< read for what is seen, and by count_texels
  bool nan = false;          ///< some visible fragment's colour is NaN
};

struct ResolveKernels {
  /// Shades what the tile holds and writes it to the picture, with the background where nothing is seen.
  void (*resolve)(ResolveTask& task) = nullptr;
  /// Adds the texels that the clear path has read for the fragments that were replaced.
  void (*count_texels)(ResolveTask& task) = nullptr;
};
ResolveKernels resolve_kernels(Simd simd);

/// Whether replaced fragments must be kept, because the number of texels differs from fragment to fragment.
bool needs_replaced(const Pass<float>& pass, const std::vector<FastSurface>& surfaces);

/// Shades the tile into the picture and adds what the clear path would have counted.
void resolve_tile(const Pass<float>& pass, const ResolveKernels& kernels, const TileFragments& tile,
                  const TileRect& rect, AttributeRows& rows, Frame& frame, Counters& counters);

}  // namespace ps::raster
