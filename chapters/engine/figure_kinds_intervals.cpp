#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/figure_kinds.h"
#include "engine/figure_rules.h"

namespace ps {
namespace {

constexpr double row_apart = 0.8, bar_height = 0.36;

/// "a=1,4,6,7": two intervals.
std::vector<FigureInterval> intervals_of(FigureValues& values, std::string_view key, std::vector<double> otherwise) {
  const std::vector<double> ends = values.numbers(key, std::move(otherwise));
  if (ends.size() % 2 != 0 || !std::is_sorted(ends.begin(), ends.end()))
    values.refuse(key, "pairs of ends, each larger than the one before");
  std::vector<FigureInterval> parts;
  for (std::size_t i = 0; i < ends.size(); i += 2) parts.emplace_back(ends[i], ends[i + 1]);
  return parts;
}

void draw_bars(FigureMarks& marks, const std::vector<FigureInterval>& parts, double y, Role role) {
  for (const auto& [from, to] : parts)
    add_polygon(marks, {{from, y}, {to, y}, {to, y + bar_height}, {from, y + bar_height}}, figure_stroke(role), 0.35);
}

double last_end(const std::vector<FigureInterval>& parts) { return parts.empty() ? 0 : parts.back().second; }

/// The intervals of t in which a ray is inside two solids, and in which inside their combination.
void draw_intervals(FigureValues& values, FigureMarks& marks) {
  const auto a = intervals_of(values, "a", {1, 5}), b = intervals_of(values, "b", {3, 7});
  const std::string_view name = values.word("operation", {"union", "intersection", "difference"});
  const FigureOperation operation = name == "union"          ? FigureOperation::join
                                    : name == "intersection" ? FigureOperation::overlap
                                                             : FigureOperation::cut;
  const auto names = values.names("names", {"$A$", "$B$"});
  const std::string_view sign = name == "union" ? "\\cup" : name == "intersection" ? "\\cap" : "-";
  const auto both = combined(a, b, operation);
  const double end = std::max(last_end(a), last_end(b)) + 1;
  for (const auto* parts : {&a, &b})
    for (const auto& [from, to] : *parts)
      for (const double t : {from, to})
        add_line(marks, {{t, -2 * row_apart}, {t, row_apart}}, figure_stroke(Role::faint, thin_line));
  draw_bars(marks, a, 0, Role::a);
  draw_bars(marks, b, -row_apart, Role::b);
  draw_bars(marks, both, -2 * row_apart, Role::right);
  const double middle = bar_height / 2;
  add_label(marks, {0, middle}, label_left, names.first, Role::a);
  add_label(marks, {0, middle - row_apart}, label_left, names.second, Role::b);
  add_label(marks, {0, middle - 2 * row_apart}, label_left, fmt::format("{} ${}$ {}", names.first, sign, names.second),
            Role::right);
  add_arrow(marks, {0, row_apart}, {end, row_apart}, figure_stroke(Role::light));
  add_dot(marks, {0, row_apart});
  add_label(marks, {0, row_apart}, label_left, "eye");
  add_label(marks, {end, row_apart}, label_right, "$t$", Role::light);
}

/// Shadow volumes along the ray to a surface: one more at each face in front, one less at each face behind.
void draw_volume_count(FigureValues& values, FigureMarks& marks) {
  const auto volumes = intervals_of(values, "volumes", {2, 6, 4, 8});
  const double surface = values.number("surface", 7, {0.5, 100});
  struct Crossing {
    double t;
    int step;
  };
  std::vector<Crossing> crossings;
  double end = surface + 1;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const auto& [enter, leave] = volumes[i];
    end = std::max(end, leave + 0.5);
    const double y = 0.7 + row_apart * static_cast<double>(i);
    draw_bars(marks, {{std::max(enter, 0.0), leave}}, y, Role::quiet);
    if (enter > 0) crossings.push_back({enter, 1});
    crossings.push_back({leave, -1});
    for (const double t : {enter, leave})
      if (t > 0) add_line(marks, {{t, 0}, {t, y}}, figure_stroke(Role::faint, thin_line));
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
  add_arrow(marks, {0, 0}, {surface, 0}, figure_stroke(Role::light, 2));
  add_line(marks, {{surface, -0.5}, {surface, 0.5}}, figure_stroke(Role::ink, thick_line));
  add_line(marks, {{surface, 0}, {end, 0}}, figure_stroke(Role::faint, thin_line));
  int count = 0;
  for (const Crossing& crossing : crossings) {
    if (crossing.t > surface) break;
    count += crossing.step;
    add_dot(marks, {crossing.t, 0}, crossing.step > 0 ? Role::a : Role::b);
    add_label(marks, {crossing.t, 0}, label_below, crossing.step > 0 ? "$+1$" : "$-1$",
              crossing.step > 0 ? Role::a : Role::b);
  }
  add_dot(marks, {0, 0});
  add_label(marks, {0, 0}, label_below, "eye");
  add_label(marks, {surface, -0.5}, label_below, fmt::format("$\\text{{sum }} {}$", count));
}

/// The leaves of a tree of cells over points.
void draw_cells(FigureValues& values, FigureMarks& marks) {
  const std::vector<Vec2d> points =
      values.pairs("points", {{1.2, 6.6}, {1.7, 6.2}, {2.4, 7.1}, {6.3, 1.4}, {6.6, 1.1}, {6.9, 1.7}, {4.5, 4.6}});
  const int most = static_cast<int>(values.number("most", 1, {1, 100})),
            depth = static_cast<int>(values.number("depth", 4, {0, 6}));
  constexpr double side = 8;
  for (const Vec2d& point : points)
    if (!(point.x >= 0 && point.y >= 0 && point.x < side && point.y < side))
      values.refuse("points", "points from (0,0) up to (8,8)");
  for (const FigureCell& cell : quadtree_leaves(points, {{0, 0}, side, 0}, most, depth)) {
    const Vec2d low = cell.low, across(cell.size, 0), up(0, cell.size);
    add_polygon(marks, {low, low + across, low + across + up, low + up}, figure_stroke(Role::quiet, thin_line),
                cell.count > 0 ? 0.12 : 0);
  }
  for (const Vec2d& point : points) add_dot(marks, point, Role::b);
}

constexpr std::array kinds_of_intervals{FigureKind{"intervals", draw_intervals},
                                        FigureKind{"volume-count", draw_volume_count},
                                        FigureKind{"cells-of-a-tree", draw_cells}};

}  // namespace

std::span<const FigureKind> interval_figures() { return kinds_of_intervals; }

}  // namespace ps
