#include "scene/ear_clipper.h"

#include <algorithm>
#include <cmath>

namespace ps {
namespace {

bool lies_before(const Vec2d& a, const Vec2d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

double cross_of(const Vec2d& a, const Vec2d& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

EarClipper::EarClipper(const std::vector<Vec2d>& flat, std::int64_t& work)
    : flat_(flat), work_(work), next_(flat.size()), previous_(flat.size()), shares_place_(flat.size(), 0),
      left_(flat.size()), low_(flat[0]) {
  const auto count = static_cast<std::uint32_t>(flat.size());
  std::vector<std::uint32_t> order(count);
  Vec2d high = low_;
  for (std::uint32_t i = 0; i < count; ++i) {
    order[i] = i;
    next_[i] = (i + 1) % count;
    previous_[i] = (i + count - 1) % count;
    low_ = {std::min(low_.x, flat[i].x), std::min(low_.y, flat[i].y)};
    high = {std::max(high.x, flat[i].x), std::max(high.y, flat[i].y)};
  }
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return lies_before(flat[a], flat[b]); });
  for (std::uint32_t i = 1; i < count; ++i)
    if (flat[order[i]] == flat[order[i - 1]]) shares_place_[order[i]] = shares_place_[order[i - 1]] = 1;
  no_area_ = 1e-12 * std::max((high - low_).x * (high - low_).x, (high - low_).y * (high - low_).y);
  columns_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(count))) / 2 + 1;
  cell_ = (high - low_) / static_cast<double>(columns_);
  cells_.resize(columns_ * columns_);
  for (std::uint32_t i = 0; i < count; ++i) cells_[row(flat[i].y) * columns_ + column(flat[i].x)].push_back(i);
}

/// turn_of, or 0 where it is no more than rounding leaves of vertices in a row.
double EarClipper::turn_at(const Vec2d& a, const Vec2d& b, const Vec2d& c) const {
  const double turn = turn_of(a, b, c);
  return std::abs(turn) > no_area_ ? turn : 0;
}

std::size_t EarClipper::column(double x) const {
  if (!(cell_.x > 0)) return 0;
  return static_cast<std::size_t>(std::clamp((x - low_.x) / cell_.x, 0.0, static_cast<double>(columns_ - 1)));
}
std::size_t EarClipper::row(double y) const {
  if (!(cell_.y > 0)) return 0;
  return static_cast<std::size_t>(std::clamp((y - low_.y) / cell_.y, 0.0, static_cast<double>(columns_ - 1)));
}

std::vector<std::array<std::uint32_t, 3>> EarClipper::run() {
  triangles_.reserve(flat_.size() - 2);
  while (left_ > 3 && (clip_one(Pass::ears) || clip_one(Pass::without_area) || clip_one(Pass::clockwise))) {
  }
  std::uint32_t first = tip_;
  for (std::uint32_t i = next_[tip_]; i != tip_; i = next_[i]) first = std::min(first, i);
  for (std::uint32_t i = next_[first]; next_[i] != first; i = next_[i]) {
    if (left_ == 3 && turn_of(flat_[first], flat_[i], flat_[next_[i]]) < 0)
      triangles_.push_back({next_[i], i, first});
    else
      triangles_.push_back({first, i, next_[i]});
  }
  return std::move(triangles_);
}

/// Goes once around what is left, from tip_ on, until a triangle could be cut off.
bool EarClipper::clip_one(Pass pass) {
  for (std::size_t tried = 0; tried < left_ && work_ > 0; ++tried, tip_ = next_[tip_]) {
    --work_;
    if (!may_go(tip_, pass)) continue;
    const std::uint32_t tip = tip_;
    if (pass == Pass::clockwise)
      triangles_.push_back({next_[tip], tip, previous_[tip]});
    else
      triangles_.push_back({previous_[tip], tip, next_[tip]});
    // The change is around the gap; ears go on behind it, so that triangles do not all share one vertex.
    tip_ = pass == Pass::ears ? next_[tip] : previous_[tip];
    remove(tip);
    return true;
  }
  return false;
}

bool EarClipper::may_go(std::uint32_t tip, Pass pass) {
  const Vec2d &a = flat_[previous_[tip]], &b = flat_[tip], &c = flat_[next_[tip]];
  const double turn = turn_at(a, b, c);
  switch (pass) {
  case Pass::ears:
    // Where both edges are run along a second time, the other way, there may be no area to fill between them.
    return turn > 0 && is_free(tip, 1) && (shares_place_[tip] == 0 || winding_around((a + b + c) / 3.0) > 0);
  case Pass::without_area:
    return turn == 0;
  case Pass::clockwise:
    return turn < 0 && is_free(tip, -1) && winding_around((a + b + c) / 3.0) < 0;
  }
  return false;
}

/// Whether no edge runs through the triangle at `tip`, which turns left (facing 1) or right (-1).
bool EarClipper::is_free(std::uint32_t tip, double facing) {
  const std::uint32_t before = previous_[tip], after = next_[tip];
  const std::array<Vec2d, 3> ear{flat_[facing > 0 ? before : after], flat_[tip], flat_[facing > 0 ? after : before]};
  const auto [low_x, high_x] = std::minmax({ear[0].x, ear[1].x, ear[2].x});
  const auto [low_y, high_y] = std::minmax({ear[0].y, ear[1].y, ear[2].y});
  const std::size_t last_row = row(high_y), first_column = column(low_x), last_column = column(high_x);
  for (std::size_t y = row(low_y); y <= last_row; ++y) {
    for (std::size_t x = first_column; x <= last_column; ++x) {
      const std::vector<std::uint32_t>& cell = cells_[y * columns_ + x];
      work_ -= static_cast<std::int64_t>(cell.size()) + 1;
      for (const std::uint32_t i : cell) {
        if (i == before || i == tip || i == after) continue;
        const Vec2d& p = flat_[i];
        if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
        const std::array<double, 3> sides{turn_at(ear[0], ear[1], p), turn_at(ear[1], ear[2], p),
                                          turn_at(ear[2], ear[0], p)};
        if (sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0 && enters(i, ear, sides)) return false;
      }
    }
  }
  return true;
}

/// Whether an edge at `vertex`, which lies in the triangle or on its outline, runs into it. `sides` are 0 for those of
/// its edges on which the vertex lies.
bool EarClipper::enters(std::uint32_t vertex, const std::array<Vec2d, 3>& ear,
                        const std::array<double, 3>& sides) const {
  for (const std::uint32_t neighbour : {next_[vertex], previous_[vertex]}) {
    const Vec2d direction = flat_[neighbour] - flat_[vertex];
    bool inwards = true;
    for (std::size_t k = 0; k < 3; ++k)
      if (sides[k] == 0) inwards = inwards && cross_of(ear[(k + 1) % 3] - ear[k], direction) > no_area_;
    if (inwards) return true;
  }
  return false;
}

/// How often what is left of the polygon runs around a point, counter-clockwise.
int EarClipper::winding_around(const Vec2d& point) {
  int winding = 0;
  std::uint32_t i = tip_;
  do {
    const Vec2d &a = flat_[i], &b = flat_[next_[i]];
    if ((a.y <= point.y) != (b.y <= point.y)) {
      const double side = turn_of(a, b, point);
      if (a.y <= point.y && side > 0) ++winding;
      if (a.y > point.y && side < 0) --winding;
    }
    i = next_[i];
  } while (i != tip_);
  work_ -= static_cast<std::int64_t>(left_);
  return winding;
}

void EarClipper::remove(std::uint32_t tip) {
  next_[previous_[tip]] = next_[tip];
  previous_[next_[tip]] = previous_[tip];
  std::vector<std::uint32_t>& cell = cells_[row(flat_[tip].y) * columns_ + column(flat_[tip].x)];
  *std::find(cell.begin(), cell.end(), tip) = cell.back();
  cell.pop_back();
  --left_;
}

}  // namespace ps
