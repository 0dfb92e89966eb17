#include "study/label_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ps {
namespace {

struct Rect {
  Vec2d low, high;
  bool meets(const Rect& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
};

/// Does any of the line lie inside? Clipped against one side after another (Liang and Barsky).
bool crosses(const LabelLine& line, const Rect& rect) {
  double from = 0, to = 1;
  const Vec2d along = line.second - line.first;
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const double speed = side * along[axis];
      const double room = side < 0 ? line.first[axis] - rect.low[axis] : rect.high[axis] - line.first[axis];
      if (speed == 0 && room < 0) return false;
      if (speed > 0) to = std::min(to, room / speed);
      if (speed < 0) from = std::max(from, room / speed);
    }
  return from < to;
}

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

/// Do the lines cross? Lines that only touch, as those of two marks in one place do, do not.
bool cross_each_other(const LabelLine& a, const LabelLine& b) {
  const auto side = [](const LabelLine& line, const Vec2d& p) {
    const Vec2d along = line.second - line.first, to = p - line.first;
    return along.x * to.y - along.y * to.x;
  };
  return side(a, b.first) * side(a, b.second) < 0 && side(b, a.first) * side(b, a.second) < 0;
}

/// The point of a label that is nearest to its mark.
Vec2d nearest_to_mark(const LabelWish& wish, const Vec2d& corner) {
  const Vec2d high = corner + wish.size;
  return {std::clamp(wish.mark.x, corner.x, high.x), std::clamp(wish.mark.y, corner.y, high.y)};
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelWish>& wishes, const Vec2d& box, double radius,
                                     const std::vector<LabelLine>& lines) {
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
  const auto is_free = [&](const Rect& rect) {
    if (rect.low.x < 0 || rect.low.y < 0 || rect.high.x > box.x || rect.high.y > box.y) return false;
    return std::none_of(taken.begin(), taken.end(), [&](const Rect& other) { return rect.meets(other); });
  };
  // From the middle of the mark: where the drawn leader begins depends on the size of the mark.
  std::vector<LabelLine> leaders;
  std::vector<Rect> labels;
  const auto reaches = [&](const LabelLine& leader, const Rect& rect) {
    return std::none_of(
               leaders.begin(), leaders.end(),
               [&](const LabelLine& other) { return cross_each_other(leader, other) || crosses(other, rect); }) &&
           std::none_of(labels.begin(), labels.end(), [&](const Rect& other) { return crosses(leader, other); });
  };
  std::vector<LabelPlace> places(wishes.size());
  for (const std::size_t i : order) {
    std::optional<Rect> found;
    LabelLine leader;
    for (const Vec2d& corner : candidates(wishes[i], radius)) {
      const Rect rect{corner, corner + wishes[i].size};
      const LabelLine line{wishes[i].mark, nearest_to_mark(wishes[i], corner)};
      if (!is_free(rect) || !reaches(line, rect)) continue;
      const bool clear =
          std::none_of(lines.begin(), lines.end(), [&](const LabelLine& other) { return crosses(other, rect); });
      if (!found || clear) {
        found = rect;
        leader = line;
      }
      if (clear) break;
    }
    if (!found) continue;
    places[i] = {true, found->low};
    taken.push_back(*found);
    labels.push_back(*found);
    leaders.push_back(leader);
  }
  return places;
}

std::optional<LabelLine> label_leader(const LabelWish& wish, const LabelPlace& place, double radius) {
  if (!place.shown) return {};
  const Vec2d end = nearest_to_mark(wish, place.corner);
  const Vec2d away = end - wish.mark;
  const double distance = std::hypot(away.x, away.y);
  if (distance < 2 * radius + 4) return {};
  return LabelLine{wish.mark + away * (radius / distance), end};
}

}  // namespace ps
