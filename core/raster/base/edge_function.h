#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "base/parallel.h"
#include "math/vec.h"
#include "options/settings.h"

namespace ps::raster {

/// Canvas positions in fixed point, counted from the top left of the picture in units of 2^-(subpixel_bits + 1) pixels.
/// Vertices are rounded to 2^-subpixel_bits, so they are even; the spare bit lets samples lie at the centre of a pixel
/// even with 0 sub-pixel bits.
struct FixedPoint {
  std::int32_t x = 0, y = 0;
  bool operator==(const FixedPoint&) const = default;
};

/// Triangles must lie within this distance of the picture's top left corner, in pixels, before they are rounded: then a
/// coordinate has at most 15 + 13 bits, a difference 29, a product 58 and an edge value 60, which fits 64. It is also
/// the longest side of a picture that the rasterizer draws.
inline constexpr int guard_band = 32768;

/// The units per pixel of FixedPoint.
inline std::int64_t fixed_unit(int subpixel_bits) { return std::int64_t{1} << (subpixel_bits + 1); }

/// Rounds a position (pixels from the top left, within the guard band) to the nearest sub-pixel; halves go to even.
template <class Real>
inline FixedPoint to_fixed(const Vec2<Real>& position, int subpixel_bits) {
  const double scale = static_cast<double>(std::int64_t{1} << subpixel_bits);
  return {static_cast<std::int32_t>(2 * std::lrint(static_cast<double>(position.x) * scale)),
          static_cast<std::int32_t>(2 * std::lrint(static_cast<double>(position.y) * scale))};
}

/// Which samples a triangle covers, decided exactly (CGPP 15.6.4; stability.md rows 17-21). Edge i lies opposite vertex
/// i; its value at a sample is twice the area that sample and edge span, positive inside. The three values add up to
/// `area`, so value / area is the screen-space barycentric weight of vertex i. Two triangles that share an edge compute
/// the same number with opposite signs, so the fill rule gives each sample on it to exactly one of them.
struct EdgeFunctions {
  std::array<std::int64_t, 3> at_origin{};  ///< values at the sample of pixel (0, 0)
  std::array<std::int64_t, 3> step_x{};     ///< change from one column to the next
  std::array<std::int64_t, 3> step_y{};     ///< change from one row to the next
  std::array<std::int64_t, 3> threshold{};  ///< the sample is inside where value > threshold: -1 if the edge owns ties
  std::int64_t area = 0;                    ///< twice the triangle's area; positive

  std::array<std::int64_t, 3> at(int column, int row) const {
    std::array<std::int64_t, 3> value;
    for (std::size_t i = 0; i < 3; ++i) value[i] = at_origin[i] + step_x[i] * column + step_y[i] * row;
    return value;
  }
  bool inside(const std::array<std::int64_t, 3>& value) const {
    return value[0] > threshold[0] && value[1] > threshold[1] && value[2] > threshold[2];
  }
};

/// How samples lie on the fixed-point grid and who owns ties.
struct CoverageGrid {
  int subpixel_bits = 8;
  FillRule fill_rule = FillRule::top_left;
  Vec2d sample{0.5, 0.5};  ///< of the sample inside its pixel, a multiple of one half
  int samples = 1;         ///< of a pixel; more than one lie anywhere in it (multisample.h)
};

/// Twice the triangle's area, exactly; its sign is the orientation.
inline std::int64_t doubled_area(const std::array<FixedPoint, 3>& corner) {
  const auto across = [&](std::size_t k) { return std::int64_t{corner[k].x} - corner[0].x; };
  const auto down = [&](std::size_t k) { return std::int64_t{corner[k].y} - corner[0].y; };
  return across(1) * down(2) - down(1) * across(2);
}

/// The edges of a triangle in either orientation; nullopt for a triangle with zero area.
inline std::optional<EdgeFunctions> make_edges(const std::array<FixedPoint, 3>& corner, const CoverageGrid& grid) {
  const std::int64_t unit = fixed_unit(grid.subpixel_bits);
  const auto sample_x = static_cast<std::int64_t>(grid.sample.x * static_cast<double>(unit));
  const auto sample_y = static_cast<std::int64_t>(grid.sample.y * static_cast<double>(unit));
  EdgeFunctions edges;
  const std::int64_t area = doubled_area(corner);
  if (area == 0) return {};
  const std::int64_t sign = area > 0 ? 1 : -1;
  edges.area = sign * area;
  for (std::size_t i = 0; i < 3; ++i) {
    const FixedPoint& a = corner[(i + 1) % 3];
    const FixedPoint& b = corner[(i + 2) % 3];
    const std::int64_t dx = sign * (std::int64_t{b.x} - a.x);
    const std::int64_t dy = sign * (std::int64_t{b.y} - a.y);
    edges.at_origin[i] = dx * (sample_y - a.y) - dy * (sample_x - a.x);
    edges.step_x[i] = -dy * unit;
    edges.step_y[i] = dx * unit;
    switch (grid.fill_rule) {
    case FillRule::top_left:  // rows grow downwards: a left edge runs up, a top edge runs right
      edges.threshold[i] = dy < 0 || (dy == 0 && dx > 0) ? -1 : 0;
      break;
    case FillRule::inclusive:
      edges.threshold[i] = -1;
      break;
    case FillRule::exclusive:
      edges.threshold[i] = 0;
      break;
    }
  }
  return edges;
}

/// Pixels whose samples may lie inside, not yet cut to the picture.
inline TileRect sample_box(const std::array<FixedPoint, 3>& corner, const CoverageGrid& grid) {
  const std::int64_t unit = fixed_unit(grid.subpixel_bits);
  const int shift = grid.subpixel_bits + 1;
  const auto sample_x = static_cast<std::int64_t>(grid.sample.x * static_cast<double>(unit));
  const auto sample_y = static_cast<std::int64_t>(grid.sample.y * static_cast<double>(unit));
  const std::int64_t low_x = std::min({corner[0].x, corner[1].x, corner[2].x}) - sample_x;
  const std::int64_t low_y = std::min({corner[0].y, corner[1].y, corner[2].y}) - sample_y;
  const std::int64_t high_x = std::max({corner[0].x, corner[1].x, corner[2].x}) - sample_x;
  const std::int64_t high_y = std::max({corner[0].y, corner[1].y, corner[2].y}) - sample_y;
  const auto ceiling = [&](std::int64_t v) { return static_cast<int>((v + unit - 1) >> shift); };
  const auto floor_next = [&](std::int64_t v) { return static_cast<int>((v >> shift) + 1); };
  const std::int64_t half = grid.samples > 1 ? unit / 2 : 0;  // maximum distance of sub-samples from the centre
  return {ceiling(low_x - half), ceiling(low_y - half), floor_next(high_x + half), floor_next(high_y + half)};
}

}  // namespace ps::raster
