#pragma once
#include "raster/pass.h"

namespace ps::raster {

/// Whether draw_fast() can make this picture: float, perspective, per-pixel shading, one depth buffer of 1 / z,
/// fast_channels alone, and no surface that the batched shading leaves to the clear path.
bool can_draw_fast(const Pass<float>& pass);

/// The fast path of a whole picture, with the clear path's bits and counts: vertices and triangles in vectors,
/// visibility first, and then each visible fragment shaded once. Fills `frame`, whose colours, depths and ids may be
/// unfilled, its counters and its times.
void draw_fast(const Pass<float>& pass, const RenderRequest& request, Frame& frame, Progress& progress);

}  // namespace ps::raster
