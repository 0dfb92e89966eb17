#pragma once
#include <cstdint>

#include "options/settings.h"
#include "raster/base/edge_function.h"
#include "raster/fast/shade_batch.h"

namespace ps::raster {

/// The fast path of coverage and depth: all samples of a triangle's box in one tile, several at once. It repeats
/// EdgeFunctions::inside, make_fragment and the depth test to the last bit. Perspective pictures in float only.
struct TriangleScan {
  const EdgeFunctions* edges = nullptr;
  TileRect box;  ///< inside the tile, not empty
  float inverse_area = 1;
  std::array<float, 3> inverse_z{};
  std::array<float, 3> stored_depth{};             ///< of the vertices: 1 / z or z, as `depth_value` says
  DepthValue depth_value = DepthValue::inverse_z;  ///< others are left to the clear path
  float* depth = nullptr;  ///< the depth buffer at the box's first pixel; nullptr = no depth test
  int depth_stride = 0;    ///< from one row to the next
  int frame_width = 0;     ///< of the picture
};

struct ScanCounts {
  std::uint64_t fragments = 0;
  std::uint64_t depth_failures = 0;
};

/// Whether the edge values over the box can be held exactly by the numbers that the fast path counts with.
bool can_scan(const TriangleScan& scan);

/// Scans rows from `row` on, appending visible samples to the batch and writing their depth, until the box ends or the
/// batch may not hold another row. Returns the next row to scan.
using ScanTriangle = int (*)(const TriangleScan& scan, int row, ShadeBatch& batch, ScanCounts& counts);

/// The function for this setting on this processor; nullptr means the clear path.
ScanTriangle scan_function(Simd simd);

}  // namespace ps::raster
