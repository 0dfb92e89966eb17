#pragma once
#include <cmath>
#include <optional>

#include "gui/platform/texture.h"
#include "gui/session/session.h"

namespace ps::gui {

/// A map of all pixels, as large as fits the room; a click picks the pixel of that side. Answers the pixel under the
/// mouse.
std::optional<Vec2i> pixel_map(const char* name, const Texture& texture, ImVec2 room, Session& session, Side side);

/// The pixel with that value that is nearest to the centre of all such pixels.
template <class T>
std::optional<Vec2i> typical_pixel(const Image<T>& map, const T& value) {
  Vec2d middle{0, 0};
  double count = 0;
  const auto each = [&](const auto& visit) {
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x)
        if (map.at(x, y) == value) visit(x, y);
  };
  each([&](int x, int y) {
    middle += Vec2d(x, y);
    ++count;
  });
  if (count == 0) return {};
  middle /= count;
  std::optional<Vec2i> best;
  double least = INFINITY;
  each([&](int x, int y) {
    const double distance = std::hypot(x - middle.x, y - middle.y);
    if (distance < least) {
      least = distance;
      best = Vec2i(x, y);
    }
  });
  return best;
}

}  // namespace ps::gui
