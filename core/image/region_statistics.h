#pragma once
#include <array>
#include <cstdint>

#include "base/parallel.h"
#include "image/image.h"

namespace ps {

/// Statistics of one channel over a rectangle, in display levels.
struct ChannelStatistics {
  int lowest = 0, highest = 0;
  double mean = 0, deviation = 0;              ///< standard deviation of all pixels
  std::array<std::uint32_t, 256> histogram{};  ///< pixels at each level
};

struct RegionStatistics {
  std::uint64_t pixels = 0;
  std::array<ChannelStatistics, 3> channels;  ///< red, green, blue
};

/// Statistics of the part of a rectangle that lies in the picture.
RegionStatistics region_statistics(const Image<Rgb8>& levels, const TileRect& rect);

}  // namespace ps
