#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/figure_kinds.h"
#include "engine/figure_rules.h"
#include "math/power.h"

namespace ps {
namespace {

constexpr double chart_width = 8, chart_height = 4.5;

/// Which side of each edge a place lies on, by the edge functions of a triangle.
void draw_edge_signs(FigureValues& values, FigureMarks& marks) {
  const std::vector<Vec2d> corners = values.pairs("corners", {{1, 0.5}, {6, 1.5}, {3, 5}});
  if (corners.size() != 3 || !(edge_value(corners[0], corners[1], corners[2]) > 0))
    values.refuse("corners", "three vertices, counter-clockwise");
  const std::array<Vec2d, 3> v{corners[0], corners[1], corners[2]};
  const Vec2d middle = (v[0] + v[1] + v[2]) / 3.0;
  std::vector<Vec2d> places{middle};
  for (std::size_t i = 0; i < 3; ++i) {
    places.push_back(middle + 2.0 * ((v[i] + v[(i + 1) % 3]) / 2.0 - middle));  // beyond an edge
    places.push_back(middle + 1.45 * (v[i] - middle));                          // beyond a vertex
  }
  places = values.pairs("points", places);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d &from = v[i], &to = v[(i + 1) % 3];
    add_line(marks, {from - 0.4 * (to - from), to + 0.4 * (to - from)}, figure_stroke(Role::quiet, thin_line, dashed));
  }
  add_polygon(marks, corners, figure_stroke(Role::a, 2), 0.15);
  for (const Vec2d& place : places) {
    std::string signs;
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool positive = edge_value(v[i], v[(i + 1) % 3], place) > 0;
      signs += positive ? "+" : "−";
      inside = inside && positive;
    }
    add_label(marks, place, label_on, fmt::format("$\\text{{{}}}$", signs), inside ? Role::right : Role::wrong);
  }
}

/// A graph in a chart with axes.
struct Chart {
  double low_x, high_x, low_y, high_y;
  Vec2d operator()(double x, double y) const {
    return {(x - low_x) / (high_x - low_x) * chart_width, (y - low_y) / (high_y - low_y) * chart_height};
  }
};

void draw_axes(FigureMarks& marks, std::string_view x, std::string_view y) {
  add_arrow(marks, {0, 0}, {chart_width * 1.06, 0}, figure_stroke(Role::quiet, thin_line));
  add_arrow(marks, {0, 0}, {0, chart_height * 1.1}, figure_stroke(Role::quiet, thin_line));
  add_label(marks, {chart_width * 1.06, 0}, label_right, x);
  add_label(marks, {0, chart_height * 1.1}, label_above, y);
}

/// The depth along a span of the screen, and the straight line that it is not.
void draw_depth_along_span(FigureValues& values, FigureMarks& marks) {
  const double first = values.number("first", 1, {0.01, 1000}), last = values.number("last", 6, {0.01, 1000});
  const double at = values.number("at", 0.5, {0, 1});
  const Chart chart{0, 1, 0, std::max(first, last)};
  draw_axes(marks, "$x$", "$z$");
  std::vector<Vec2d> curve;
  for (int i = 0; i <= 48; ++i) curve.push_back(chart(i / 48.0, depth_on_screen(first, last, i / 48.0)));
  add_line(marks, {chart(0, first), chart(1, last)}, figure_stroke(Role::wrong, 2, dashed));
  add_line(marks, std::move(curve), figure_stroke(Role::right, 2));
  const double right = depth_on_screen(first, last, at), wrong = first + at * (last - first);
  add_line(marks, {chart(at, 0), chart(at, wrong)}, figure_stroke(Role::quiet, thin_line, dotted));
  add_dot(marks, chart(at, right), Role::right);
  add_dot(marks, chart(at, wrong), Role::wrong);
  add_label(marks, chart(at, right), {0.9, -0.9}, fmt::format("${:.4g}$", right), Role::right);
  add_label(marks, chart(at, wrong), {-0.9, 0.9}, fmt::format("${:.4g}$", wrong), Role::wrong);
  add_label(marks, chart(0, first), label_left, fmt::format("${:g}$", first));
  add_label(marks, chart(1, last), label_right, fmt::format("${:g}$", last));
}

/// Powers of x, of n, or of the cosine of an angle.
void draw_powers(FigureValues& values, FigureMarks& marks) {
  const std::string_view of = values.word("of", {"x", "n", "cosine"});
  const bool cosine = of == "cosine";
  const std::vector<double> exponents = values.numbers("exponents", {1, 2.2}, {cosine ? 0.1 : -8, 1000});
  const double low = values.number("from", cosine ? -90 : 0, {-90, 100}),
               high = values.number("to", cosine ? 90 : 1, {-89, 100});
  const double top = values.number("top", 1, {0.01, 1000});
  if (!(low < high)) values.refuse("to", "more than where it begins");
  const Chart chart{low, high, 0, top};
  draw_axes(marks, cosine ? "$\\alpha$" : fmt::format("${}$", of), "");
  constexpr std::array roles{Role::a, Role::b, Role::right, Role::wrong};
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const Role role = roles[i % roles.size()];
    std::vector<Vec2d> curve;
    for (int k = 0; k <= 96; ++k) {
      const double x = low + (high - low) * k / 96;
      const double y = power(cosine ? std::max(figure_direction(x).x, 0.0) : x, exponents[i]);
      if (y <= top) curve.push_back(chart(x, y));
    }
    if (curve.size() < 2) values.refuse("exponents", "curves below the top");
    const std::string base = cosine ? "\\cos" : std::string(of), space = cosine ? " \\alpha" : "";
    const std::string exponent = exponents[i] == 1 ? "" : fmt::format("^{{{:.3g}}}", exponents[i]);
    const double height = 0.85 - 0.22 * static_cast<double>(i % roles.size());  // labels lie below each other
    const Vec2d at = cosine ? chart(portable::acos(power(height, 1 / exponents[i])) * 180 / std::numbers::pi, height)
                            : curve[curve.size() * (i + 2) / (exponents.size() + 3)];
    add_label(marks, at, cosine ? Vec2d(1, 0.5) : Vec2d(-0.8, 0.8), fmt::format("${}{}{}$", base, exponent, space),
              role);
    add_line(marks, std::move(curve), figure_stroke(role, 2));
  }
  for (const double x : {low, high}) add_label(marks, chart(x, 0), label_below, fmt::format("${:g}$", x));
  add_label(marks, chart(low, top), label_left, fmt::format("${:g}$", top));
}

/// A pixel's footprint on a ground of texels, seen from above.
void draw_footprint(FigureValues& values, FigureMarks& marks) {
  const double height = values.number("height", 4, {0.1, 100}), distance = values.number("distance", 12, {0.1, 1000}),
               pixel = values.number("pixel", 0.1, {0.001, 1});
  if (!(height / distance > pixel / 2)) values.refuse("distance", "a distance at which the pixel is below the horizon");
  const Footprint print = footprint_of(height, distance, pixel);
  const double length = print.far - print.near;
  const double from = std::floor(print.near) - 1, to = std::ceil(print.far) + 1,
               half = std::ceil(print.far_width / 2) + 1;
  if ((to - from) * 2 * half > 2000) values.refuse("distance", "a footprint of fewer texels");
  for (double y = -half; y <= half; ++y) add_line(marks, {{from, y}, {to, y}}, figure_stroke(Role::faint, thin_line));
  for (double x = from; x <= to; ++x) add_line(marks, {{x, -half}, {x, half}}, figure_stroke(Role::faint, thin_line));
  add_polygon(marks,
              {{print.near, -print.near_width / 2},
               {print.far, -print.far_width / 2},
               {print.far, print.far_width / 2},
               {print.near, print.near_width / 2}},
              figure_stroke(Role::b, 2), 0.25);
  add_dot(marks, {distance, 0}, Role::b);
  add_label(marks, {(from + to) / 2, -half}, label_below,
            fmt::format("{:.1f} texels long, {:.1f} wide", length, pixel * distance), Role::b);
}

/// A house before and after a rotation and a translation, in either order.
void draw_transforms(FigureValues& values, FigureMarks& marks) {
  const double angle = values.number("angle", 40, {-180, 180});
  const std::vector<Vec2d> move = values.pairs("move", {{4, 1}});
  if (move.size() != 1) values.refuse("move", "one pair");
  const bool turn_first = values.word("order", {"turn-move", "move-turn"}) == "turn-move";
  const Vec2d x = figure_direction(angle), y = figure_direction(angle + 90);
  const auto turned = [&](const Vec2d& p) { return p.x * x + p.y * y; };
  const auto moved = [&](const Vec2d& p) { return p + move.front(); };
  const auto first = [&](const Vec2d& p) { return turn_first ? turned(p) : moved(p); };
  const auto both = [&](const Vec2d& p) { return turn_first ? moved(turned(p)) : turned(moved(p)); };
  const std::array house{Vec2d(-0.8, 0), Vec2d(0.8, 0), Vec2d(0.8, 1), Vec2d(0, 1.7), Vec2d(-0.8, 1)};
  const auto draw = [&](const auto& map, const Stroke& stroke, double opacity) {
    std::vector<Vec2d> corners;
    corners.reserve(house.size());
    for (const Vec2d& corner : house) corners.push_back(map(corner));
    add_polygon(marks, std::move(corners), stroke, opacity);
  };
  add_arrow(marks, {-2, 0}, {5.5, 0}, figure_stroke(Role::faint, thin_line));
  add_arrow(marks, {0, -1}, {0, 4}, figure_stroke(Role::faint, thin_line));
  draw([](const Vec2d& p) { return p; }, figure_stroke(Role::quiet, thin_line), 0);
  draw(first, figure_stroke(Role::a, plain_line, dashed), 0);
  draw(both, figure_stroke(Role::b, 2), 0.2);
  add_dot(marks, {0, 0});
  add_label(marks, {0, 0}, label_below, "origin");
  add_label(marks, first({0, 0.5}), label_on, "1", Role::a);
  add_label(marks, both({0, 0.5}), label_on, "2", Role::b);
}

/// The depths that a buffer of integers can hold, which are even in 1/z.
void draw_depth_steps(FigureValues& values, FigureMarks& marks) {
  const double near = values.number("near", 1, {0.01, 100}), far = values.number("far", 10, {0.02, 1000});
  const int steps = static_cast<int>(values.number("steps", 16, {1, 256}));
  if (!(near < far)) values.refuse("far", "a far plane beyond the near one");
  const Chart chart{0, far, 0, 1};
  add_arrow(marks, {0, 0}, {chart_width * 1.06, 0}, figure_stroke(Role::quiet, thin_line));
  for (int i = 0; i <= steps; ++i) {
    const double x = chart(depth_on_screen(near, far, static_cast<double>(i) / steps), 0).x;
    add_line(marks, {{x, -0.25}, {x, 0.25}}, figure_stroke(Role::a));
  }
  add_dot(marks, {0, 0});
  add_label(marks, {0, 0}, label_above, "eye");
  add_label(marks, {chart(near, 0).x, -0.25}, label_below, fmt::format("$n = {:g}$", near), Role::a);
  add_label(marks, {chart(far, 0).x, -0.25}, label_below, fmt::format("${:g}$", far), Role::a);
  add_label(marks, {chart_width * 1.06, 0}, label_right, "$z$");
}

constexpr std::array kinds_of_rasters{
    FigureKind{"edge-signs", draw_edge_signs},   FigureKind{"depth-along-span", draw_depth_along_span},
    FigureKind{"depth-steps", draw_depth_steps}, FigureKind{"powers", draw_powers},
    FigureKind{"footprint", draw_footprint},     FigureKind{"transforms", draw_transforms}};

}  // namespace

std::span<const FigureKind> raster_figures() { return kinds_of_rasters; }

}  // namespace ps
