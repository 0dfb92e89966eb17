#include "engine/figure_rules.h"

#include <algorithm>
#include <cmath>

namespace ps {
namespace {

double cross_of(const Vec2d& a, const Vec2d& b) { return a.x * b.y - a.y * b.x; }
double product_of(const Vec2d& a, const Vec2d& b) { return a.x * b.x + a.y * b.y; }

bool is_inside(const std::vector<FigureInterval>& parts, double t) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const FigureInterval& part) { return t > part.first && t < part.second; });
}

bool holds(FigureOperation operation, bool in_a, bool in_b) {
  switch (operation) {
  case FigureOperation::join:
    return in_a || in_b;
  case FigureOperation::overlap:
    return in_a && in_b;
  case FigureOperation::cut:
    return in_a && !in_b;
  }
  return false;
}

}  // namespace

std::vector<FigureInterval> combined(const std::vector<FigureInterval>& a, const std::vector<FigureInterval>& b,
                                     FigureOperation operation) {
  std::vector<double> ends;
  for (const auto* parts : {&a, &b})
    for (const FigureInterval& part : *parts) ends.insert(ends.end(), {part.first, part.second});
  std::sort(ends.begin(), ends.end());
  std::vector<FigureInterval> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = (ends[i] + ends[i + 1]) / 2;
    if (!(ends[i] < ends[i + 1]) || !holds(operation, is_inside(a, middle), is_inside(b, middle))) continue;
    if (!result.empty() && result.back().second == ends[i])
      result.back().second = ends[i + 1];
    else
      result.emplace_back(ends[i], ends[i + 1]);
  }
  return result;
}

Vec2d reflected(const Vec2d& to_light, const Vec2d& normal) {
  return 2 * product_of(normal, to_light) * normal - to_light;
}

double edge_value(const Vec2d& a, const Vec2d& b, const Vec2d& p) { return cross_of(b - a, p - a); }

double depth_on_screen(double first, double last, double s) { return 1 / ((1 - s) / first + s / last); }

Vec2d meeting(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  return a + cross_of(c - a, d - c) / cross_of(b - a, d - c) * (b - a);
}

std::vector<double> circle_hits(const Vec2d& origin, const Vec2d& direction, const Vec2d& middle, double radius) {
  const Vec2d from_middle = origin - middle;
  const double a = product_of(direction, direction), b = 2 * product_of(from_middle, direction),
               c = product_of(from_middle, from_middle) - radius * radius, discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return {};
  const double root = std::sqrt(discriminant);
  return {(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

std::vector<FigureCell> quadtree_leaves(const std::vector<Vec2d>& points, const FigureCell& root, int most, int depth) {
  FigureCell cell = root;
  cell.count = static_cast<int>(std::count_if(points.begin(), points.end(), [&](const Vec2d& p) {
    return p.x >= cell.low.x && p.y >= cell.low.y && p.x < cell.low.x + cell.size && p.y < cell.low.y + cell.size;
  }));
  if (cell.count <= most || depth == 0) return {cell};
  std::vector<FigureCell> leaves;
  const double half = cell.size / 2;
  for (const Vec2d corner : {Vec2d(0, 0), Vec2d(half, 0), Vec2d(0, half), Vec2d(half, half)}) {
    const auto more = quadtree_leaves(points, {cell.low + corner, half, 0}, most, depth - 1);
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  return leaves;
}

Footprint footprint_of(double height, double distance, double pixel) {
  const double row = height / distance;  // below the middle of the screen
  Footprint print{height / (row + pixel / 2), height / (row - pixel / 2), 0, 0};
  print.near_width = pixel * print.near;
  print.far_width = pixel * print.far;
  return print;
}

}  // namespace ps
