#include "inspect/space_svg.h"

#include <algorithm>
#include <cmath>

#include "image/svg.h"
#include "inspect/space_projection.h"

namespace ps {
namespace {

// Okabe and Ito's colours, as in the window.
constexpr std::string_view ink = "#202020", quiet = "#707070", orange = "#e69f00", sky_blue = "#56b4e9",
                           green = "#009e73", purple = "#cc79a7", yellow = "#f0e442", paper = "#ffffff";
constexpr double letter_width = 6.2;  // of a label, about
constexpr std::string_view dashed = "8 5", dotted = "2 4";

double ray_width(double contribution) { return 1.2 + 2.8 * std::sqrt(std::clamp(contribution, 0.0, 1.0)); }

SvgStyle style_of(const SpaceItem& item) {
  switch (item.kind) {
  case SpaceKind::frustum:
  case SpaceKind::pixel_grid:
    return {quiet, 1};
  case SpaceKind::image_plane:
    return {ink, 1.5};
  case SpaceKind::pixel_cell:
    return {ink, 1, {}, yellow};
  case SpaceKind::clip_plane:
    return {quiet, 1, dashed};
  case SpaceKind::light:
    return {orange, 2, {}, orange};
  case SpaceKind::eye_ray:
    return {ink, ray_width(item.contribution)};
  case SpaceKind::sight_line:
    return {ink, 2, dashed};
  case SpaceKind::reflection_ray:
    return {sky_blue, ray_width(item.contribution)};
  case SpaceKind::shadow_ray_lit:
    return {orange, 1.8};
  case SpaceKind::shadow_ray_blocked:
    return {purple, 1.8, dashed};
  case SpaceKind::light_direction:
    return {orange, 1.6, dotted};
  case SpaceKind::hit_point:
    return {ink, 1.5, {}, item.emphasised ? ink : paper};
  case SpaceKind::shading_normal:
    return {green, 2.4};
  case SpaceKind::geometric_normal:
    return {green, 1.4, dashed};
  case SpaceKind::triangle:
    return {ink, item.emphasised ? 1.8 : 1};
  case SpaceKind::barycentric_area: {
    constexpr std::string_view tints[] = {sky_blue, orange, green};
    return {{}, 0, {}, tints[item.level % 3], 0.5};
  }
  case SpaceKind::triangle_on_image:
    return {ink, 1, {}, ink, item.emphasised ? 0.3 : 0.12};
  case SpaceKind::rejected_triangle:
    return {purple, 1, dashed};
  case SpaceKind::node:
    return {quiet, 1, item.emphasised ? std::string_view{} : dashed};
  case SpaceKind::silhouette:
    return {purple, 2.4};
  case SpaceKind::shadow_volume:
    return {purple, 1, {}, purple, 0.12};
  case SpaceKind::shadow_map:
    return {orange, 1.6, dashed};
  }
  return {};
}

bool is_shown(const SpaceItem& item, const SpaceSvgOptions& options) {
  if (item.kind == SpaceKind::node) return options.nodes && item.level <= options.deepest_level;
  if (item.kind == SpaceKind::pixel_grid) return options.grid;
  if (item.kind == SpaceKind::rejected_triangle) return options.rejected;
  return item.contribution >= options.least_contribution;
}

class SpaceSvg {
 public:
  SpaceSvg(SvgDrawing& svg, const SpacePicture& picture)
      : svg_(svg), picture_(picture), projection_(picture.view, Settings{}, picture.near) {}

  void draw(const SpaceItem& item) {
    const SvgStyle style = style_of(item);
    switch (item.shape) {
    case SpaceShape::line:
      for (std::size_t i = 1; i < item.points.size(); ++i) line(item.points[i - 1], item.points[i], style);
      return;
    case SpaceShape::arrow:
      line(item.points[0], item.points[1], style);
      return head(item.points[0], item.points[1], style);
    case SpaceShape::outline:
      for (std::size_t i = 0; i < item.points.size(); ++i)
        line(item.points[i], item.points[(i + 1) % item.points.size()], style);
      return;
    case SpaceShape::area: {
      std::vector<Vec2d> corners;
      for (const SpacePlace& place : projection_.polygon(item.points)) corners.push_back(place.at);
      if (corners.size() >= 3) svg_.polygon(corners, style);
      return;
    }
    case SpaceShape::point:
      if (const auto place = projection_.point(item.points[0])) svg_.circle(place->at, 4, style);
      return;
    case SpaceShape::box:
      return box(item.points[0], item.points[1], style);
    }
  }

  void label(const SpaceItem& item) {
    const bool at_start = item.kind == SpaceKind::frustum || item.kind == SpaceKind::light;
    const bool wanted = at_start || item.kind == SpaceKind::shading_normal || item.kind == SpaceKind::clip_plane;
    if (item.label.empty() || !wanted) return;
    const auto place = projection_.point(at_start ? item.points.front() : item.points.back());
    if (!place) return;
    const Vec2d corner = place->at + Vec2d(9, -6);
    for (const Vec2d& other : labels_)
      if (std::abs(other.y - corner.y) < 16 && std::abs(other.x - corner.x) < 130) return;
    labels_.push_back(corner);
    // On a plate of its own, since lines run everywhere.
    const double width = letter_width * static_cast<double>(item.label.size()) + 6;
    const Vec2d low = corner + Vec2d(-3, -13), high = corner + Vec2d(width - 3, 5);
    svg_.polygon({low, {high.x, low.y}, high, {low.x, high.y}}, {{}, 0, {}, paper, 0.85});
    svg_.text(corner, item.label, 13);
  }

 private:
  void line(const Vec3d& from, const Vec3d& to, SvgStyle style) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    for (const SpaceRun& run : visible_runs(picture_.depth, *seen)) {
      SvgStyle part = style;
      if (run.hidden) {
        part.dash = dotted;
        part.width = std::min(style.width, 1.2);
        part.opacity = 0.6;
      }
      svg_.line(run.from.at, run.to.at, part);
    }
  }
  void head(const Vec3d& from, const Vec3d& to, const SvgStyle& style) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    const Vec2d along = seen->to.at - seen->from.at;
    const double length = std::sqrt(dot(along, along));
    if (length < 6) return;
    const Vec2d back = along / -length * std::min(5 + style.width, length / 2);
    const Vec2d aside = Vec2d(-back.y, back.x) * 0.6;
    svg_.polygon({seen->to.at, seen->to.at + back * 1.5 + aside, seen->to.at + back * 1.5 - aside},
                 {{}, 0, {}, style.stroke});
  }
  void box(const Vec3d& low, const Vec3d& high, const SvgStyle& style) {
    const auto corner = [&](int k) {
      return Vec3d((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z);
    };
    for (int k = 0; k < 8; ++k)
      for (const int bit : {1, 2, 4})
        if ((k & bit) == 0) line(corner(k), corner(k | bit), style);
  }

  SvgDrawing& svg_;
  const SpacePicture& picture_;
  SpaceProjection projection_;
  std::vector<Vec2d> labels_;
};

/// Areas below lines below points.
int layer(const SpaceItem& item) {
  if (item.shape == SpaceShape::area) return item.kind == SpaceKind::pixel_cell ? 3 : 0;
  if (item.shape == SpaceShape::point) return 4;
  return item.event < 0 ? 1 : 2;
}

}  // namespace

std::string space_svg(const SpaceModel& model, const SpacePicture& picture, const SpaceSvgOptions& options) {
  const Vec2d size(picture.levels.width(), picture.levels.height());
  SvgDrawing svg(size.x, size.y, "The scene from outside, with the rays or triangles of one pixel");
  svg.begin_clip({0, 0}, size);
  svg.picture({0, 0}, size, paled(picture, model.ground, {255, 255, 255}));
  SpaceSvg painter(svg, picture);
  for (int wanted = 0; wanted <= 4; ++wanted)
    for (const SpaceItem& item : model.items)
      if (layer(item) == wanted && is_shown(item, options)) painter.draw(item);
  for (const SpaceItem& item : model.items)
    if (is_shown(item, options)) painter.label(item);
  svg.end_clip();
  return svg.finish();
}

}  // namespace ps
