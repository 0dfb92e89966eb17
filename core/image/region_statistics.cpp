#include "image/region_statistics.h"

#include <algorithm>
#include <cmath>

namespace ps {

RegionStatistics region_statistics(const Image<Rgb8>& levels, const TileRect& rect) {
  RegionStatistics result;
  for (int y = std::max(0, rect.y0); y < std::min(levels.height(), rect.y1); ++y)
    for (int x = std::max(0, rect.x0); x < std::min(levels.width(), rect.x1); ++x) {
      const Rgb8 p = levels.at(x, y);
      const std::array<std::uint8_t, 3> channels{p.r, p.g, p.b};
      for (std::size_t k = 0; k < 3; ++k) ++result.channels[k].histogram[channels[k]];
      ++result.pixels;
    }
  if (result.pixels == 0) return result;
  // Exact sums: at most 2^28 pixels times 255^2 fit 64 bits.
  for (ChannelStatistics& channel : result.channels) {
    std::uint64_t sum = 0, squares = 0;
    bool any = false;
    for (std::uint64_t level = 0; level < channel.histogram.size(); ++level) {
      const std::uint64_t count = channel.histogram[level];
      if (count == 0) continue;
      if (!any) channel.lowest = static_cast<int>(level);
      any = true;
      channel.highest = static_cast<int>(level);
      sum += count * level;
      squares += count * level * level;
    }
    const auto n = static_cast<double>(result.pixels);
    channel.mean = static_cast<double>(sum) / n;
    channel.deviation = std::sqrt(std::max(0.0, static_cast<double>(squares) / n - channel.mean * channel.mean));
  }
  return result;
}

}  // namespace ps
