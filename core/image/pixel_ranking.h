#pragma once
#include <cstdint>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// A pixel with the number that it was ranked by.
struct RankedPixel {
  Vec2i pixel{0, 0};  ///< array position
  double value = 0;
  bool operator==(const RankedPixel&) const = default;
};

struct RankingOptions {
  int count = 20;  ///< maximum number of pixels
  int apart = 4;   ///< a pixel this near (column or row) to one that ranks higher is left out; 0 = none is
};

/// The pixels with the largest values, the largest first; at equal values the one that comes first in reading order.
/// Pixels whose value is not above zero have no rank; one that is not a number ranks above all.
std::vector<RankedPixel> rank_pixels(const Image<float>& values, const RankingOptions& options = {});

/// For each pixel the largest difference of a channel, in levels. Both pictures must have the same size (InputError).
Image<float> level_differences(const Image<Rgb8>& a, const Image<Rgb8>& b);
/// Counts as values that can be ranked.
Image<float> as_values(const Image<std::uint32_t>& counts);

}  // namespace ps
