#include "gui/session/watched_pixels.h"

#include <algorithm>

namespace ps::gui {

bool WatchedPixels::contains(Vec2i pixel) const {
  return std::any_of(pixels_.begin(), pixels_.end(), [&](const WatchedPixel& one) { return one.pixel == pixel; });
}

void WatchedPixels::toggle(Vec2i pixel) {
  if (contains(pixel))
    std::erase_if(pixels_, [&](const WatchedPixel& one) { return one.pixel == pixel; });
  else if (pixels_.size() < most_pixels)
    pixels_.push_back({pixel, {}});
}

void WatchedPixels::note(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  for (WatchedPixel& one : pixels_) {
    const auto value = [&](const Image<Rgb8>& levels) -> std::optional<Rgb8> {
      if (!levels.contains(one.pixel.x, one.pixel.y)) return {};
      return levels.at(one.pixel.x, one.pixel.y);
    };
    const std::array now{value(a), value(b)};
    if (!one.values.empty() && one.values.back() == now) continue;
    one.values.push_back(now);
    if (one.values.size() > most_values) one.values.erase(one.values.begin());
  }
}

}  // namespace ps::gui
