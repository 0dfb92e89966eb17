#pragma once
#include "raster/pass.h"

namespace ps::raster {

/// Fills the channels that show maps and stencil buffers, and counts what those took.
template <class Real>
void store_map_pictures(const Pass<Real>& pass, Frame& frame);

}  // namespace ps::raster
