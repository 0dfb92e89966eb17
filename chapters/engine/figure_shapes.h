#pragma once
#include <cmath>
#include <string_view>
#include <vector>

#include "engine/figure.h"
#include "math/portable.h"

/// Short ways to add marks, for what draws the kinds of figures.

namespace ps {

using FigureMarks = std::vector<FigureMark>;

inline constexpr double thin_line = 1, plain_line = 1.5, thick_line = 3;

inline Stroke figure_stroke(Role role = Role::ink, double width = plain_line, Dash dash = unbroken) {
  return {.tint = {role}, .width = width, .dash = dash};
}

void add_line(FigureMarks& marks, std::vector<Vec2d> places, const Stroke& stroke = figure_stroke());
void add_arrow(FigureMarks& marks, const Vec2d& from, const Vec2d& to, const Stroke& stroke = figure_stroke());
/// `corners` of a convex polygon, with an inside of this opacity.
void add_polygon(FigureMarks& marks, std::vector<Vec2d> corners, const Stroke& stroke, double opacity = 0);
void add_dot(FigureMarks& marks, const Vec2d& at, Role role = Role::ink);
/// `text` is as in a figure's description.
void add_label(FigureMarks& marks, const Vec2d& at, const Vec2d& side, std::string_view text, Role role = Role::ink);

/// Places on a part of a circle, angles in degrees counter-clockwise from the right.
std::vector<Vec2d> arc_places(const Vec2d& middle, double radius, double from, double to);
/// The arc at `corner` from the direction of `from` to that of `to`, with a label outside its middle.
void add_angle(FigureMarks& marks, const Vec2d& from, const Vec2d& corner, const Vec2d& to, double radius,
               std::string_view text, Role role = Role::ink);

inline double figure_length(const Vec2d& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

inline Vec2d figure_direction(double degrees) {
  constexpr double radian = 0.017453292519943295;
  return {portable::cos(degrees * radian), portable::sin(degrees * radian)};
}

inline constexpr Vec2d label_left{-1, 0}, label_right{1, 0}, label_above{0, 1}, label_below{0, -1}, label_on{0, 0};

}  // namespace ps
