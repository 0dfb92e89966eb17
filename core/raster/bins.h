#pragma once
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "raster/geometry.h"

namespace ps::raster {

/// Names a triangle or a line: number `index` of batch `batch`.
struct PrimitiveRef {
  std::uint32_t batch = 0;
  std::uint32_t index = 0;
};

/// All triangles (or lines) in the order in which they are drawn: as submitted, or for the painter from back to front.
/// At equal depth the painter draws the lowest index last, so that it wins there as it does everywhere.
template <class Real>
std::vector<PrimitiveRef> drawing_order(const Pass<Real>& pass, const ScreenGeometry<Real>& geometry);

/// For each tile the primitives whose box touches it, in drawing order. `tile_size` is the one the tiles were made
/// with.
template <class Real>
std::vector<std::vector<PrimitiveRef>> bin_primitives(const Pass<Real>& pass, const ScreenGeometry<Real>& geometry,
                                                      const std::vector<PrimitiveRef>& order, int tile_size);

}  // namespace ps::raster
