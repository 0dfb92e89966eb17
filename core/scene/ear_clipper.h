#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace ps {

/// Twice the signed area of a, b, c: above 0 if the path turns left at b.
inline double turn_of(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Cuts a polygon that is not convex. Its winding number is the sum of its triangles' ones, whatever is cut off. So a
/// triangle of three neighbours may go as soon as no edge runs through it and the polygon winds around it as it does:
/// that also holds for polygons that touch themselves. Vertices lie in a grid, so that few are looked at for each.
class EarClipper {
 public:
  /// Keeps both; `work` goes down by one for each vertex looked at.
  EarClipper(const std::vector<Vec2d>& flat, std::int64_t& work);
  std::vector<std::array<std::uint32_t, 3>> run();

 private:
  /// In this order: what turns left, then what has no area (spikes, vertices on straight edges), then loops that run
  /// clockwise.
  enum class Pass { ears, without_area, clockwise };

  bool clip_one(Pass pass);
  bool may_go(std::uint32_t tip, Pass pass);
  bool is_free(std::uint32_t tip, double facing);
  bool enters(std::uint32_t vertex, const std::array<Vec2d, 3>& ear, const std::array<double, 3>& sides) const;
  int winding_around(const Vec2d& point);
  double turn_at(const Vec2d& a, const Vec2d& b, const Vec2d& c) const;
  void remove(std::uint32_t tip);
  std::size_t column(double x) const;
  std::size_t row(double y) const;

  const std::vector<Vec2d>& flat_;
  std::int64_t& work_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<char> shares_place_;  ///< with another vertex
  std::uint32_t tip_ = 0;           ///< the vertex to be tried next
  std::size_t left_;
  double no_area_ = 0;  ///< twice the area up to which a triangle counts as a line
  Vec2d low_, cell_;    ///< the grid's corner, and the size of a cell
  std::size_t columns_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace ps
