#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/figure_kinds.h"
#include "engine/figure_rules.h"
#include "shade/fresnel.h"

namespace ps {
namespace {

const Vec2d hit_point(0, 0), upright(0, 1);

Vec2d unit_of_sum(const Vec2d& a, const Vec2d& b) {
  const Vec2d sum = a + b;
  const double length = figure_length(sum);
  return length > 0 ? sum / length : upright;
}

void draw_surface_line(FigureMarks& marks, double reach) {
  add_polygon(marks, {{-reach, 0}, {reach, 0}, {reach, -0.12}, {-reach, -0.12}}, figure_stroke(Role::faint, thin_line),
              0.8);
  add_line(marks, {{-reach, 0}, {reach, 0}}, figure_stroke(Role::ink, thick_line));
}

/// Similar triangles: what a point at (y, z) becomes on the projection plane.
void draw_projection(FigureValues& values, FigureMarks& marks) {
  const double distance = values.number("distance", 1, {0.01, 1000});
  const std::vector<Vec2d> points = values.pairs("points", {{4, 2}});
  double depth = distance, height = 0;
  for (const Vec2d& point : points) {
    if (!(point.x > 0)) values.refuse("points", "points in front of the camera: z above 0");
    depth = std::max(depth, point.x);
    height = std::max({height, std::abs(point.y), std::abs(point.y) * distance / point.x});
  }
  const bool below = std::any_of(points.begin(), points.end(), [](const Vec2d& point) { return point.y < 0; });
  const Stroke plane = figure_stroke(Role::a, thick_line), help = figure_stroke(Role::quiet, thin_line, dashed);
  add_arrow(marks, {0, 0}, {depth * 1.15, 0}, figure_stroke(Role::quiet, thin_line));
  add_line(marks, {{distance, below ? -1.15 * height : 0}, {distance, height * 1.15}}, plane);
  add_label(marks, {distance, height * 1.15}, label_above, "projection plane", Role::a);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2d& point = points[i];
    const Vec2d image(distance, point.y * distance / point.x);
    const std::string index = points.size() > 1 ? fmt::format("_{}", i + 1) : "";
    const double away = point.y < 0 ? -1 : 1;
    add_line(marks, {{0, 0}, point}, figure_stroke(Role::light));
    add_line(marks, {{point.x, 0}, point}, help);
    add_dot(marks, point);
    add_dot(marks, image, Role::a);
    add_label(marks, point, {0, away}, fmt::format("$P{}$", index));
    if (points.size() > 1) continue;
    add_label(marks, image, {-0.7, 0.7 * away}, "$P'$", Role::a);
    add_label(marks, {point.x, point.y / 2}, label_right, "$y$");
    add_label(marks, {distance, image.y / 2}, label_right, "$y'$", Role::a);
    add_label(marks, {point.x, 0}, {0, -away}, "$z$");
    add_label(marks, {distance, 0}, {0, -away}, "$d$", Role::a);
  }
  add_dot(marks, {0, 0});
  add_label(marks, {0, 0}, below ? label_left : label_below, "$O$");
}

/// N, and what is asked for of L, V, R and H, at a point of a surface.
void draw_surface(FigureValues& values, FigureMarks& marks) {
  const double light = values.number("light", 50, {-89, 89}), eye = values.number("eye", 20, {-89, 89});
  const auto shown = values.words("show", {"N", "L", "V", "R", "H", "angle", "eye-angle"});
  const auto has = [&](std::string_view name) { return std::find(shown.begin(), shown.end(), name) != shown.end(); };
  const Vec2d to_light = figure_direction(90 + light), to_eye = figure_direction(90 - eye);
  const Vec2d mirrored = reflected(to_light, upright), halfway = unit_of_sum(to_light, to_eye);
  draw_surface_line(marks, 1);
  const auto arrow = [&](std::string_view name, const Vec2d& direction, Role role) {
    if (!has(name)) return;
    add_arrow(marks, hit_point, direction, figure_stroke(role, 2));
    add_label(marks, direction, direction, fmt::format("$\\vec {}$", name), role);
  };
  arrow("N", upright, Role::ink);
  arrow("L", to_light, Role::light);
  arrow("V", to_eye, Role::a);
  arrow("R", mirrored, Role::b);
  arrow("H", halfway, Role::right);
  if (has("angle")) add_angle(marks, upright, hit_point, to_light, 0.38, "$\\alpha$", Role::light);
  if (has("eye-angle")) {
    const Vec2d from = has("H") ? halfway : mirrored, to = has("H") ? upright : to_eye;
    add_angle(marks, from, hit_point, to, 0.55, "$\\beta$", Role::quiet);
  }
  add_dot(marks, hit_point);
  add_label(marks, hit_point, label_below, "$P$");
}

/// R as twice the part of L (or V) along N, minus L: the steps of its derivation.
void draw_reflection(FigureValues& values, FigureMarks& marks) {
  const double angle = values.number("angle", 50, {5, 85});
  const std::string_view name = values.word("vector", {"L", "V"});
  const Vec2d to_light = figure_direction(90 + angle), mirrored = reflected(to_light, upright);
  const Vec2d foot(0, to_light.y), twice(0, 2 * to_light.y);
  draw_surface_line(marks, 1);
  add_line(marks, {hit_point, twice}, figure_stroke(Role::quiet, thin_line, dashed));
  add_arrow(marks, hit_point, to_light, figure_stroke(Role::light, 2));
  add_arrow(marks, hit_point, foot, figure_stroke(Role::ink, thick_line));
  add_arrow(marks, twice, mirrored, figure_stroke(Role::light, plain_line, dashed));
  add_arrow(marks, hit_point, mirrored, figure_stroke(Role::b, 2));
  add_line(marks, {to_light, foot}, figure_stroke(Role::quiet, thin_line, dotted));
  add_angle(marks, upright, hit_point, to_light, 0.3, "$\\alpha$");
  add_angle(marks, mirrored, hit_point, upright, 0.3, "$\\alpha$");
  add_dot(marks, twice);
  add_label(marks, to_light, to_light, fmt::format("$\\vec {}$", name), Role::light);
  add_label(marks, mirrored, mirrored, "$\\vec R$", Role::b);
  add_label(marks, foot, {0.8, 0.8}, fmt::format("$\\vec N (\\vec N \\cdot \\vec {})$", name));
  add_label(marks, twice, label_above, fmt::format("$2 \\vec N (\\vec N \\cdot \\vec {})$", name));
  add_label(marks, (twice + mirrored) / 2.0, {0.8, 0.5}, fmt::format("$-\\vec {}$", name), Role::light);
  add_label(marks, hit_point, label_below, "$P$");
}

/// Snell's law, by the routine with which the ray tracer bends its rays.
void draw_refraction(FigureValues& values, FigureMarks& marks) {
  const double angle = values.number("angle", 50, {0, 89}), from = values.number("from", 1, {0.1, 10}),
               to = values.number("to", 1.5, {0.1, 10});
  const Vec2d came = figure_direction(90 + angle), mirrored = reflected(came, upright);
  const auto bent = refract(Vec3d(-came.x, -came.y, 0), Vec3d(0, 1, 0), from, to);
  const double reach = 1.15;
  add_polygon(marks, {{-reach, 0}, {reach, 0}, {reach, -1}, {-reach, -1}}, figure_stroke(Role::faint, thin_line), 0);
  const Role denser = Role::mirror;
  const double low = to >= from ? -1 : 1;
  marks.emplace_back(FigureArea{{{-reach, 0}, {reach, 0}, {reach, low}, {-reach, low}}, {denser, 0.15}});
  add_line(marks, {{-reach, 0}, {reach, 0}}, figure_stroke(Role::ink, 2));
  add_line(marks, {{0, -1}, {0, 1}}, figure_stroke(Role::quiet, thin_line, dashed));
  add_arrow(marks, came, 0.45 * came, figure_stroke(Role::light, 2));
  add_line(marks, {0.5 * came, hit_point}, figure_stroke(Role::light, 2));
  add_angle(marks, upright, hit_point, came, 0.35, "$\\theta_1$", Role::light);
  add_label(marks, {reach, 0.12}, {-1, 1}, fmt::format("$n_1 = {:g}$", from));
  add_label(marks, {reach, -0.12}, {-1, -1}, fmt::format("$n_2 = {:g}$", to));
  if (!bent) {
    add_arrow(marks, hit_point, mirrored, figure_stroke(Role::b, 2));
    add_label(marks, mirrored, label_above, "all is reflected", Role::b);
    return;
  }
  const Vec2d beyond(bent->direction.x, bent->direction.y);
  add_arrow(marks, hit_point, 0.55 * mirrored, figure_stroke(Role::quiet, plain_line, dashed));
  add_arrow(marks, hit_point, beyond, figure_stroke(Role::a, 2));
  if (angle > 0) add_angle(marks, -upright, hit_point, beyond, 0.45, "$\\theta_2$", Role::a);
}

/// Why a shadow map has acne: each texel holds one depth, for a part of the surface that is at many.
void draw_map_steps(FigureValues& values, FigureMarks& marks) {
  const double angle = values.number("angle", 30, {1, 70}), bias = values.number("bias", 0, {0, 10});
  const int texels = static_cast<int>(values.number("texels", 6, {1, 40}));
  const double slope = portable::tan(angle * std::numbers::pi / 180);
  const auto surface = [&](double x) { return -slope * x; };  // the light shines straight down: y is minus its depth
  add_line(marks, {{0, 0}, {static_cast<double>(texels), surface(texels)}}, figure_stroke(Role::ink, plain_line));
  for (int i = 0; i < texels; ++i) {
    const double middle = i + 0.5, stored = surface(middle) - bias;
    const double lit_to = std::min(i + 1.0, bias / slope + middle);  // where the surface sinks below what is stored
    if (lit_to < i + 1)
      add_line(marks, {{lit_to, surface(lit_to)}, {i + 1.0, surface(i + 1)}}, figure_stroke(Role::wrong, 5));
    add_line(marks, {{static_cast<double>(i), stored}, {i + 1.0, stored}}, figure_stroke(Role::a, 2));
    add_arrow(marks, {middle, 1.2}, {middle, surface(middle)}, figure_stroke(Role::light, thin_line));
  }
  add_label(marks, {texels / 2.0, 1.2}, label_above, "rays from the light, one for each texel", Role::light);
  add_label(marks, {static_cast<double>(texels), surface(texels - 0.5) - bias}, label_right, "stored", Role::a);
}

constexpr std::array kinds_of_rays{FigureKind{"projection", draw_projection}, FigureKind{"surface", draw_surface},
                                   FigureKind{"reflection", draw_reflection}, FigureKind{"refraction", draw_refraction},
                                   FigureKind{"map-steps", draw_map_steps}};

}  // namespace

std::span<const FigureKind> ray_figures() { return kinds_of_rays; }

}  // namespace ps
