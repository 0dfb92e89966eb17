#pragma once
#include <span>
#include <vector>

#include "base/parallel.h"
#include "raster/assembly/screen_geometry.h"

namespace ps::raster {

/// The samples that coverage is asked for: those of the triangle's box, or all where no box is used.
template <class Real>
TileRect tested_box(const RasterInputs<Real>& inputs, const ScreenTriangle<Real>& triangle) {
  if (inputs.coverage.strategy != Coverage::ray_test) return triangle.box;
  return {0, 0, inputs.viewport.columns, inputs.viewport.rows};
}

/// All triangles (or lines) in the order in which they are drawn: as submitted, or for the painter from back to front.
/// At equal depth the painter draws the lowest index last, so that it wins there as it does everywhere. Sorted blending
/// draws what is opaque as submitted, and then what is translucent as the painter does.
template <class Real>
std::vector<PrimitiveRef> drawing_order(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry);

/// For each tile the primitives whose box touches it. Drawing order is cut into parts, so that several threads can sort
/// them: a tile draws its list of part 0, then of part 1 and so on.
struct Bins {
  std::size_t tiles = 0;
  std::size_t parts = 0;
  std::vector<std::vector<PrimitiveRef>> lists;  ///< of part p and tile t: number p * tiles + t
  const std::vector<PrimitiveRef>& list(std::size_t part, std::size_t tile) const { return lists[part * tiles + tile]; }
};

/// Sorts the primitives of `order` into tiles. `tile_size` is the one the tiles were made with. The parts do not depend
/// on the number of threads.
template <class Real>
Bins bin_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                    std::span<const PrimitiveRef> order, int tile_size, const ParallelOptions& parallel,
                    Progress& progress);
/// The same with all of them, in drawing order.
template <class Real>
Bins bin_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry, int tile_size,
                    const ParallelOptions& parallel, Progress& progress);

}  // namespace ps::raster
