#include "engine/figure_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ps {
namespace {

constexpr double degrees_of_chord = 4;

double degrees_of(const Vec2d& direction) { return portable::atan2(direction.y, direction.x) * 180 / std::numbers::pi; }

}  // namespace

void add_line(FigureMarks& marks, std::vector<Vec2d> places, const Stroke& stroke) {
  marks.emplace_back(FigureLine{std::move(places), stroke, LineTip::plain});
}

void add_arrow(FigureMarks& marks, const Vec2d& from, const Vec2d& to, const Stroke& stroke) {
  marks.emplace_back(FigureLine{{from, to}, stroke, LineTip::arrow});
}

void add_polygon(FigureMarks& marks, std::vector<Vec2d> corners, const Stroke& stroke, double opacity) {
  if (opacity > 0) marks.emplace_back(FigureArea{corners, {stroke.tint.role, opacity}});
  corners.push_back(corners.front());
  add_line(marks, std::move(corners), stroke);
}

void add_dot(FigureMarks& marks, const Vec2d& at, Role role) { marks.emplace_back(FigureDot{at, {role}}); }

void add_label(FigureMarks& marks, const Vec2d& at, const Vec2d& side, std::string_view text, Role role) {
  if (text.empty()) return;
  FigureLabel label = read_label(text, {});
  label.at = at;
  label.side = side;
  label.tint = {role};
  marks.emplace_back(std::move(label));
}

std::vector<Vec2d> arc_places(const Vec2d& middle, double radius, double from, double to) {
  const int chords = static_cast<int>(std::clamp(std::ceil(std::abs(to - from) / degrees_of_chord), 1.0, 360.0));
  std::vector<Vec2d> places;
  for (int i = 0; i <= chords; ++i)
    places.push_back(middle + radius * figure_direction(from + (to - from) * i / chords));
  return places;
}

void add_angle(FigureMarks& marks, const Vec2d& from, const Vec2d& corner, const Vec2d& to, double radius,
               std::string_view text, Role role) {
  const double begin = degrees_of(from - corner);
  double turn = degrees_of(to - corner) - begin;
  turn -= 360 * std::round(turn / 360);  // the shorter way round
  add_line(marks, arc_places(corner, radius, begin, begin + turn), figure_stroke(role, thin_line));
  const Vec2d outwards = figure_direction(begin + turn / 2);
  add_label(marks, corner + radius * outwards, outwards, text, role);
}

}  // namespace ps
