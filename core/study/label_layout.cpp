#include "study/label_layout.h"

#include <algorithm>
#include <numeric>

namespace ps {
namespace {

struct Rect {
  Vec2d low, high;
  bool meets(const Rect& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
};

/// Right, left, above, below, the corners; then the same farther away.
std::vector<Vec2d> candidates(const LabelWish& wish, double radius) {
  std::vector<Vec2d> corners;
  const Vec2d& s = wish.size;
  for (const double gap : {radius + 3, 2.5 * radius + 8, 4 * radius + 16}) {
    const double left = wish.mark.x - gap - s.x, right = wish.mark.x + gap, middle_x = wish.mark.x - s.x / 2;
    const double above = wish.mark.y - gap - s.y, below = wish.mark.y + gap, middle_y = wish.mark.y - s.y / 2;
    for (const Vec2d& corner :
         {Vec2d(right, middle_y), Vec2d(right, above), Vec2d(middle_x, above), Vec2d(right, below),
          Vec2d(middle_x, below), Vec2d(left, middle_y), Vec2d(left, above), Vec2d(left, below)})
      corners.push_back(corner);
  }
  return corners;
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelWish>& wishes, const Vec2d& box, double radius) {
  std::vector<Rect> taken;
  for (const LabelWish& wish : wishes) {
    taken.push_back({wish.mark - radius, wish.mark + radius});
    const double half = radius / 3;  // about the thickness of a bar's ends
    if (wish.bar != Vec2d(0, 0))
      taken.push_back({wish.mark - Vec2d(wish.bar.x, half), wish.mark + Vec2d(wish.bar.y, half)});
  }
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wishes[a].rank < wishes[b].rank; });
  std::vector<LabelPlace> places(wishes.size());
  for (const std::size_t i : order)
    for (const Vec2d& corner : candidates(wishes[i], radius)) {
      const Rect rect{corner, corner + wishes[i].size};
      if (rect.low.x < 0 || rect.low.y < 0 || rect.high.x > box.x || rect.high.y > box.y) continue;
      if (std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return rect.meets(other); })) continue;
      places[i] = {true, corner};
      taken.push_back(rect);
      break;
    }
  return places;
}

}  // namespace ps
