#pragma once
#include "image/display.h"
#include "raster/fast/attribute_rows.h"

namespace ps::raster {

/// Whether what is written stays in the cache, or goes past it: right for a picture that is larger than the cache and
/// that is not read tile by tile, for then no line is fetched first only to be overwritten. Who asks for levels and is
/// called for each tile reads the levels.
enum class Stores { in_cache, past_cache };

/// Where a tile's colours go.
struct TileOutput {
  Vec3f* pixels = nullptr;  ///< of the picture, row by row
  std::size_t width = 0;    ///< of the picture
  Rgb8* levels = nullptr;   ///< their display levels, or nullptr
  DisplayTransform transform;
  Stores colour_stores = Stores::in_cache, level_stores = Stores::in_cache;
};

/// What shading a tile needs to know, and what it finds out.
struct ResolveTask {
  const TileFragments& tile;
  TileRect rect;
  AttributeRows& rows;
  const TileOutput& output;
  Vec3f background{0, 0, 0};
  std::uint64_t texels = 0;  ///< read for visible fragments, and by count_texels
  bool nan = false;          ///< some visible fragment's colour is NaN
};

struct ResolveKernels {
  /// Shades what the tile holds and writes it to the picture, with the background where no surface is visible.
  void (*resolve)(ResolveTask& task) = nullptr;
  /// Gives every pixel of the rectangle one colour.
  void (*fill)(const TileRect& rect, const TileOutput& output, const Vec3f& colour) = nullptr;
  /// Adds the texels that the clear path has read for the fragments that were replaced.
  void (*count_texels)(ResolveTask& task) = nullptr;
};
ResolveKernels resolve_kernels(Simd simd);

/// Whether replaced fragments must be kept, because the number of texels differs from fragment to fragment.
bool needs_replaced(const RasterInputs<float>& inputs, const std::vector<FastSurface>& surfaces);

/// Where the frame's colours go, and what else the request asks for.
TileOutput tile_output(const Settings& settings, const RenderRequest& request, Frame& frame);

/// Shades the tile into the picture and adds what the clear path would have counted.
void resolve_tile(const RasterInputs<float>& inputs, const ResolveKernels& kernels, const TileFragments& tile,
                  const TileRect& rect, const TileOutput& output, AttributeRows& rows, Frame& frame,
                  Counters& counters);

/// The same for a tile in which there is nothing.
void resolve_empty_tile(const RasterInputs<float>& inputs, const ResolveKernels& kernels, const TileRect& rect,
                        const TileOutput& output, Frame& frame, Counters& counters);

}  // namespace ps::raster
