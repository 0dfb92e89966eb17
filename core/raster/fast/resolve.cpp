#include "raster/fast/resolve.h"

#include <algorithm>
#include <limits>

#include "frame/display_frame.h"
#include "math/has_nan.h"

namespace ps::raster {
namespace {

/// Colours that fill more than the share of the last cache that a program can count on.
constexpr std::size_t past_cache_bytes = std::size_t{4} << 20;

/// Texels of every fragment; 0 where the level of detail decides.
std::uint64_t texels_of_fragment(TextureFilter filter) {
  switch (filter) {
  case TextureFilter::nearest:
    return 1;
  case TextureFilter::bilinear:
  case TextureFilter::mipmap:
    return 4;
  case TextureFilter::trilinear:
    return 0;
  }
  return 0;
}

void count(const RasterInputs<float>& inputs, const std::vector<FastSurface>& surfaces, const TileFragments& tile,
           Counters& counters) {
  const std::uint64_t texels = texels_of_fragment(inputs.settings.texture_filter);
  std::uint64_t written = 0;
  for (std::size_t i = 0; i < tile.passed.size(); ++i) {
    const std::uint64_t passed = tile.passed[i];
    const AttributeLayout& layout = inputs.surfaces[i].layout;
    written += passed;
    counters[Counter::attributes_interpolated] += passed * static_cast<std::uint64_t>(layout.count);
    if (surfaces[i].textured) counters[Counter::texel_reads] += passed * texels;
    if (!layout.lit) continue;
    counters[Counter::shading_calls] += passed;
    counters[Counter::light_samples] += passed * inputs.lights.size();
  }
  counters[Counter::fragments] += tile.fragments;
  counters[Counter::depth_tests] += tile.fragments;
  counters[Counter::attributes_interpolated] += tile.fragments;
  counters[Counter::depth_failures] += tile.fragments - written;
  counters[Counter::pixels_written] += written;
}

/// Which triangle of the scene's a tile's one is; nothing for TileFragments::none.
PixelId shown_id(const RasterInputs<float>& inputs, const TileFragments& tile, std::uint32_t id) {
  if (id == TileFragments::none) return {};
  const TileTriangle& seen = tile.triangles[id];
  const Surface<float>& surface = inputs.surfaces[seen.surface()];
  if (surface.sphere) return {surface.object, 0};
  const std::uint32_t number = seen.triangle->triangle;
  return {surface.object,
          seen.triangle->is_general() ? seen.part->cut.triangles[number].triangle : static_cast<std::int32_t>(number)};
}

/// What write_channels() of draw_primitives.cpp writes of the fragments that are seen in the end, and what "nothing is
/// seen" means elsewhere.
void store_channels(const RasterInputs<float>& inputs, const TileFragments& tile, const TileRect& rect, Frame& frame) {
  std::uint32_t last = TileFragments::none;
  PixelId shown;
  for (int row = rect.y0; row < rect.y1; ++row) {
    const std::size_t first = static_cast<std::size_t>(row - rect.y0) * fast_tile;
    const auto width = static_cast<std::size_t>(rect.width());
    if (!frame.ids.empty()) {
      PixelId* const to = &frame.ids.at(rect.x0, row);
      for (std::size_t i = 0; i < width; ++i) {
        const std::uint32_t id = tile.id[first + i];
        if (id != last) shown = shown_id(inputs, tile, last = id);
        to[i] = shown;
      }
    }
    if (!frame.depth.empty()) {
      float* const to = &frame.depth.at(rect.x0, row);
      for (std::size_t i = 0; i < width; ++i)
        to[i] = tile.id[first + i] == TileFragments::none ? std::numeric_limits<float>::infinity()
                                                          : 1.0f / tile.inverse_z[first + i];
    }
  }
}

}  // namespace

bool needs_replaced(const RasterInputs<float>& inputs, const std::vector<FastSurface>& surfaces) {
  return texels_of_fragment(inputs.settings.texture_filter) == 0 &&
         std::any_of(surfaces.begin(), surfaces.end(), [](const FastSurface& surface) { return surface.textured; });
}

TileOutput tile_output(const Settings& settings, const RenderRequest& request, Frame& frame) {
  TileOutput output;
  output.pixels = frame.colour.pixels().data();
  output.width = static_cast<std::size_t>(frame.width());
  if (request.levels) {
    PS_ASSERT(request.levels->width() == frame.width() && request.levels->height() == frame.height(),
              "levels of the frame's size");
    output.levels = request.levels->pixels().data();
    output.transform = display_transform(settings);
  }
  if (frame.colour.pixels().size_bytes() >= past_cache_bytes) {
    if (!request.on_tile) output.level_stores = Stores::past_cache;
    if (!request.on_tile || request.levels) output.colour_stores = Stores::past_cache;
  }
  return output;
}

void resolve_tile(const RasterInputs<float>& inputs, const ResolveKernels& kernels, const TileFragments& tile,
                  const TileRect& rect, const TileOutput& output, AttributeRows& rows, Frame& frame,
                  Counters& counters) {
  rows.start(tile);
  ResolveTask task{tile, rect, rows, output, Vec3f(inputs.scene->background)};
  kernels.resolve(task);
  count(inputs, rows.surfaces(), tile, counters);
  if (needs_replaced(inputs, rows.surfaces())) {
    kernels.count_texels(task);
    counters[Counter::texel_reads] += task.texels;
  }
  if (inputs.channels != Channel::none) store_channels(inputs, tile, rect, frame);
  if (!task.nan && !has_nan(task.background)) return;
  for (int row = rect.y0; row < rect.y1; ++row)
    for (int column = rect.x0; column < rect.x1; ++column)
      counters[Counter::nan_pixels] += has_nan(frame.colour.at(column, row)) ? 1u : 0u;
}

void resolve_empty_tile(const RasterInputs<float>& inputs, const ResolveKernels& kernels, const TileRect& rect,
                        const TileOutput& output, Frame& frame, Counters& counters) {
  const Vec3f background(inputs.scene->background);
  kernels.fill(rect, output, background);
  const auto width = static_cast<std::size_t>(rect.width());
  if (has_nan(background)) counters[Counter::nan_pixels] += width * static_cast<std::size_t>(rect.y1 - rect.y0);
  const auto fill_rows = [&](auto& channel, const auto& value) {
    if (channel.empty()) return;
    for (int row = rect.y0; row < rect.y1; ++row) std::fill_n(&channel.at(rect.x0, row), width, value);
  };
  fill_rows(frame.ids, PixelId{});
  fill_rows(frame.depth, std::numeric_limits<float>::infinity());
}

}  // namespace ps::raster
