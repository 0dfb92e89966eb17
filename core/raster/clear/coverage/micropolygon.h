#pragma once
#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// A piece of a triangle that is cut into four similar ones until a piece is about a pixel (CGPP 15.6.6.4, after
/// Reyes). Vertices are in units of 2^-levels of FixedPoint's, so that every midpoint of an edge is a whole number.
struct Micropolygon {
  struct Point {
    std::int64_t x = 0, y = 0;
  };
  std::array<Point, 3> corner{};
};

inline Micropolygon::Point middle(const Micropolygon::Point& a, const Micropolygon::Point& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// Vertex 0's, 1's and 2's piece, then the one at the centre, which is upside down.
inline std::array<Micropolygon, 4> cut_in_four(const Micropolygon& t) {
  const auto& p = t.corner;
  const Micropolygon::Point m0 = middle(p[1], p[2]), m1 = middle(p[2], p[0]), m2 = middle(p[0], p[1]);
  return {{{{p[0], m2, m1}}, {{m2, p[1], m0}}, {{m1, m0, p[2]}}, {{m0, m1, m2}}}};
}

/// Cuts a triangle into micropolygons; the members are what all levels of the recursion share.
class Micropolygons {
 public:
  explicit Micropolygons(const CoverageInput& input)
      : input_(input), orientation_(doubled_area(input.corners) > 0 ? 1 : -1) {
    const auto [low_x, high_x] = std::minmax({input.corners[0].x, input.corners[1].x, input.corners[2].x});
    const auto [low_y, high_y] = std::minmax({input.corners[0].y, input.corners[1].y, input.corners[2].y});
    const std::int64_t extent = std::max(std::int64_t{high_x} - low_x, std::int64_t{high_y} - low_y);
    while ((extent >> levels_) > fixed_unit(input.grid.subpixel_bits)) ++levels_;
  }
  int levels() const { return levels_; }

  template <class Sink>
  void walk(const TileRect& box, Sink& sink) const {
    Micropolygon whole;
    for (std::size_t k = 0; k < 3; ++k)
      whole.corner[k] = {std::int64_t{input_.corners[k].x} * scale(), std::int64_t{input_.corners[k].y} * scale()};
    cut(whole, 0, box, sink);
  }

 private:
  std::int64_t scale() const { return std::int64_t{1} << levels_; }

  template <class Sink>
  void cut(const Micropolygon& piece, int level, const TileRect& box, Sink& sink) const {
    const TileRect samples = common_part(sample_box_of(piece), box);
    if (is_empty(samples)) return;
    sink.region(samples);
    if (level < levels_) {
      for (const Micropolygon& part : cut_in_four(piece)) cut(part, level + 1, box, sink);
      return;
    }
    for (int row = samples.y0; row < samples.y1; ++row)
      for (int column = samples.x0; column < samples.x1; ++column) {
        sink.test(column, row);
        if (covers(piece, column, row)) sink.cover(column, row);
      }
  }

  /// A piece is small and the sample near it, so the products stay within 64 bits.
  bool covers(const Micropolygon& piece, int column, int row) const {
    const Micropolygon::Point s = sample(column, row);
    std::array<bool, 3> tied{}, top_left{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = piece.corner[(i + 1) % 3], &b = piece.corner[(i + 2) % 3];
      const std::int64_t dx = orientation_ * (b.x - a.x), dy = orientation_ * (b.y - a.y);
      const std::int64_t value = dx * (s.y - a.y) - dy * (s.x - a.x);
      if (value < 0) return false;
      tied[i] = value == 0;
      top_left[i] = is_top_left(dx, dy);
    }
    if (!tied[0] && !tied[1] && !tied[2]) return true;
    return settle_tie(tied, top_left, column, row);
  }
  /// The sample lies on an edge of the piece. On edges of the whole triangle its own rule holds. A sample between
  /// pieces goes to one of them as if it were moved a little to the right and down, which is what the top-left rule
  /// amounts to, or the other way round where that would move it out of the triangle.
  bool settle_tie(const std::array<bool, 3>& tied, const std::array<bool, 3>& top_left, int column, int row) const {
    const auto values = input_.edges.at(column, row);
    if (!input_.edges.inside(values)) return false;
    bool moved_out = false;
    int outer = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (values[i] != 0) continue;
      ++outer;
      moved_out = !is_top_left(input_.edges.step_y[i], -input_.edges.step_x[i]);
    }
    if (outer > 1) return true;  // a vertex, which only one piece has
    for (std::size_t i = 0; i < 3; ++i)
      if (tied[i] && top_left[i] == moved_out) return false;
    return true;
  }
  static bool is_top_left(std::int64_t dx, std::int64_t dy) { return dy < 0 || (dy == 0 && dx > 0); }
  Micropolygon::Point sample(int column, int row) const {
    const std::int64_t unit = fixed_unit(input_.grid.subpixel_bits);
    const FixedPoint offset = sample_offset(input_.grid);
    return {(column * unit + offset.x) * scale(), (row * unit + offset.y) * scale()};
  }
  /// Pixels whose samples may lie in the piece.
  TileRect sample_box_of(const Micropolygon& piece) const {
    const auto& p = piece.corner;
    const Micropolygon::Point first = sample(0, 0);
    const std::int64_t pixel = fixed_unit(input_.grid.subpixel_bits) * scale();
    const auto from = [&](std::int64_t v) { return static_cast<int>(-floor_divide(-v, pixel)); };
    const auto to = [&](std::int64_t v) { return static_cast<int>(floor_divide(v, pixel) + 1); };
    return {from(std::min({p[0].x, p[1].x, p[2].x}) - first.x), from(std::min({p[0].y, p[1].y, p[2].y}) - first.y),
            to(std::max({p[0].x, p[1].x, p[2].x}) - first.x), to(std::max({p[0].y, p[1].y, p[2].y}) - first.y)};
  }

  const CoverageInput& input_;
  std::int64_t orientation_;
  int levels_ = 0;
};

template <class Sink>
void walk_micropolygons(const CoverageInput& input, const TileRect& box, Sink& sink) {
  Micropolygons(input).walk(box, sink);
}

}  // namespace ps::raster
