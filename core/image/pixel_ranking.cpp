#include "image/pixel_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/difference.h"

namespace ps {

std::vector<RankedPixel> rank_pixels(const Image<float>& values, const RankingOptions& options) {
  const auto weight = [](float value) { return std::isnan(value) ? std::numeric_limits<float>::infinity() : value; };
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < values.pixels().size(); ++i)
    if (weight(values.pixels()[i]) > 0) order.push_back(i);
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const float first = weight(values.pixels()[a]), second = weight(values.pixels()[b]);
    return first != second ? first > second : a < b;
  };
  // Sorted piece by piece: as a rule the first few suffice.
  std::vector<RankedPixel> ranked;
  Image<std::uint8_t> taken(values.width(), values.height(), 0);
  const auto width = static_cast<std::uint32_t>(values.width());
  std::size_t sorted = 0;
  for (std::size_t i = 0; i < order.size() && static_cast<int>(ranked.size()) < options.count; ++i) {
    if (i == sorted) {
      sorted = std::min(order.size(), std::max<std::size_t>(1024, sorted * 4));
      std::partial_sort(order.begin() + static_cast<std::ptrdiff_t>(i),
                        order.begin() + static_cast<std::ptrdiff_t>(sorted), order.end(), before);
    }
    const Vec2i pixel(static_cast<int>(order[i] % width), static_cast<int>(order[i] / width));
    if (taken.at(pixel.x, pixel.y) != 0) continue;
    ranked.push_back({pixel, static_cast<double>(values.at(pixel.x, pixel.y))});
    for (int y = std::max(0, pixel.y - options.apart); y <= std::min(values.height() - 1, pixel.y + options.apart); ++y)
      for (int x = std::max(0, pixel.x - options.apart); x <= std::min(values.width() - 1, pixel.x + options.apart);
           ++x)
        taken.at(x, y) = 1;
  }
  return ranked;
}

Image<float> level_differences(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  if (a.width() != b.width() || a.height() != b.height())
    throw InputError("the pictures have different sizes and cannot be compared");
  Image<float> values(a.width(), a.height());
  for (std::size_t i = 0; i < values.pixels().size(); ++i)
    values.pixels()[i] = static_cast<float>(largest_difference(a.pixels()[i], b.pixels()[i]));
  return values;
}

Image<float> as_values(const Image<std::uint32_t>& counts) {
  Image<float> values(counts.width(), counts.height());
  for (std::size_t i = 0; i < values.pixels().size(); ++i) values.pixels()[i] = static_cast<float>(counts.pixels()[i]);
  return values;
}

}  // namespace ps
