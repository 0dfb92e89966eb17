#pragma once
#include "record/renderer_row.h"

namespace ps {

/// Pictures are drawn in squares of this many pixels a side, unless whole frames are drawn by SIMD.
inline constexpr int clear_tile_size = 64;

/// The rasterizer (CGFS part II).
RendererRow rasterizer_row();

/// What the row holds, for those who want this renderer alone.
Frame render_rasterized(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                        Prepared& prepared, Progress& progress);
PixelStory inspect_rasterized(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                              Prepared& prepared, Progress& progress);
/// One number of every pixel's story into `values`: of the fragment that is seen.
void find_field_of_fragments(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress);
/// Throws InputError for a view with a side that is too long for the rasterizer.
void require_rasterized_size(const View& view);

}  // namespace ps
