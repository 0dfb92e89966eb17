#include "inspect/space_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "image/svg.h"

namespace ps {
namespace {

constexpr double hidden_opacity = 0.5, thin_opacity = 0.45, rim_opacity = 0.75;
constexpr double highlight_width = 6, rim_width = 2.5, widest_hidden = 1.2;  // pixels at scale 1, as below
constexpr double hit_radius = 5, light_radius = 5, highlight_radius = 9, cross_arm = 5, least_arrow = 6;

Tint with_opacity(Tint tint, double opacity) {
  tint.opacity = opacity;
  return tint;
}

class SpaceDrawing {
 public:
  SpaceDrawing(Painter& painter, const PaintArea& area, const SpaceProjection& projection, const Image<float>& depth,
               const SpaceLook& look)
      : painter_(painter), area_(area), projection_(projection), depth_(depth), look_(look) {}

  void draw(const SpaceItem& item) {
    const Stroke stroke = stroke_of(item);
    bright_ = item.event >= 0 && item.event == look_.highlighted;
    count(item);
    for_each_line(item, [&](const Vec3d& from, const Vec3d& to) { line(from, to, stroke); });
    if (item.kind == SpaceKind::shadow_ray_blocked) cross(item.points.back(), stroke.tint);
    if (item.shape == SpaceShape::arrow) head(item.points[0], item.points[1], stroke);
    if (item.shape == SpaceShape::area) fill(item, stroke.tint);
    if (item.shape == SpaceShape::point) mark(item, stroke.tint);
  }

  void label(const SpaceItem& item) {
    const bool bright = item.event >= 0 && item.event == look_.highlighted;
    const bool at_start = item.kind == SpaceKind::light || item.kind == SpaceKind::frustum;
    const bool always = at_start || item.kind == SpaceKind::shading_normal || item.kind == SpaceKind::clip_plane ||
                        (item.kind == SpaceKind::hit_point && item.event < 0);  // a vertex that is followed
    if (item.label.empty() || (!always && !bright)) return;
    const auto at = projection_.point(at_start ? item.points.front() : item.points.back());
    if (!at) return;
    const TextLook look{.lettering = bright ? Lettering::strong : Lettering::label,
                        .level = TextLevel::top,
                        .ground = TextGround::plate};
    const TextExtent size = painter_.extent(item.label, look.lettering);
    Vec2d corner = place(*at) + Vec2d(painter_.px(9), -size.height() - painter_.px(3));
    if (corner.x + size.width > area_.high.x - painter_.px(4)) corner.x -= size.width + painter_.px(18);
    const PaintArea taken{corner, corner + Vec2d(size.width, size.height())};
    for (const PaintArea& other : labels_)
      if (taken.low.x < other.high.x && other.low.x < taken.high.x && taken.low.y < other.high.y &&
          other.low.y < taken.high.y)
        return;
    labels_.push_back(taken);
    painter_.text(corner, item.label, look);
  }

  SpaceDrawn drawn;

 private:
  Vec2d place(const SpacePlace& place) const { return area_.low + place.at; }

  void count(const SpaceItem& item) {
    ++drawn.items;
    const SpaceGroup group = group_of(item.kind);
    if (group == SpaceGroup::rays) ++drawn.rays;
    if (group == SpaceGroup::shadows) ++drawn.shadow_rays;
    if (group == SpaceGroup::nodes) ++drawn.boxes;
  }

  void line(const Vec3d& from, const Vec3d& to, const Stroke& stroke) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    for (const SpaceRun& run : visible_runs(depth_, *seen)) {
      const Vec2d a = place(run.from), b = place(run.to);
      if (bright_) drawn.highlight_place = (a + b) / 2.0;
      segment(a, b, stroke, run.hidden);
    }
  }

  void segment(const Vec2d& a, const Vec2d& b, Stroke stroke, bool hidden) {
    const bool thin = stroke.width <= 1;
    if (hidden) stroke.width = std::min(stroke.width, widest_hidden);
    if (bright_)
      painter_.line(a, b, {{Role::attention, hidden ? hidden_opacity : 0.95}, stroke.width + highlight_width});
    if (!thin && !hidden && stroke.dash == unbroken)
      painter_.line(a, b, {{Role::paper, rim_opacity}, stroke.width + rim_width});
    stroke.tint.opacity = (thin ? thin_opacity : 1) * (hidden ? hidden_opacity : 1);
    if (hidden && stroke.dash != dotted) stroke.dash = short_dashes;
    painter_.line(a, b, stroke);
  }

  void head(const Vec3d& from, const Vec3d& to, const Stroke& stroke) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    const Vec2d tip = place(seen->to), along = tip - place(seen->from);
    const double length = std::sqrt(dot(along, along));
    if (length < painter_.px(least_arrow)) return;
    const Vec2d back = along / -length * std::min(painter_.px(5 + stroke.width), length / 2);
    const Vec2d aside = Vec2d(-back.y, back.x) * 0.6;
    const std::array corners{tip, tip + back * 1.5 + aside, tip + back * 1.5 - aside};
    painter_.polygon(corners, {.fill = with_opacity(stroke.tint, is_hidden(depth_, seen->to) ? hidden_opacity : 1)});
  }

  void cross(const Vec3d& world, const Tint& tint) {
    const auto at = projection_.point(world);
    if (!at) return;
    const Vec2d middle = place(*at);
    const double arm = painter_.px(cross_arm);
    for (const Stroke& stroke : {Stroke{{Role::paper}, 5}, Stroke{tint, 2.4}})
      for (const Vec2d& along : {Vec2d(arm, arm), Vec2d(arm, -arm)})
        painter_.line(middle - along, middle + along, stroke);
  }

  void fill(const SpaceItem& item, const Tint& tint) {
    const auto polygon = projection_.polygon(item.points);
    if (polygon.size() < 3) return;
    corners_.clear();
    for (const SpacePlace& corner : polygon) corners_.push_back(place(corner));
    double inside = 0.5;
    if (item.kind == SpaceKind::triangle_on_image) inside = item.emphasised ? 0.25 : 0.1;
    if (item.kind == SpaceKind::pixel_cell) inside = 1;
    if (item.kind == SpaceKind::shadow_volume) inside = 0.08;
    const double edge = item.kind == SpaceKind::shadow_volume ? 0.3 : 0.9;
    painter_.polygon(corners_, {with_opacity(tint, inside), Stroke{with_opacity(tint, edge), 1.2}});
    if (item.kind == SpaceKind::pixel_cell)  // a pixel is small: a ring says where it is
      painter_.circle(corners_.front(), painter_.px(6), {.stroke = Stroke{.width = 1.6}});
  }

  void mark(const SpaceItem& item, const Tint& tint) {
    const auto seen = projection_.point(item.points[0]);
    if (!seen) return;
    const Vec2d at = place(*seen);
    if (bright_) {
      drawn.highlight_place = at;
      painter_.circle(at, painter_.px(highlight_radius), {.fill = Tint{Role::attention}});
    }
    if (item.kind == SpaceKind::light) return light(at, tint);
    const Tint inside = with_opacity(tint, is_hidden(depth_, *seen) ? hidden_opacity : 1);
    painter_.circle(at, painter_.px(hit_radius), {.fill = Tint{Role::paper, inside.opacity}});
    if (item.emphasised)
      painter_.circle(at, painter_.px(3.6), {.fill = inside});
    else
      painter_.circle(at, painter_.px(3.6), {.stroke = Stroke{tint, 1.4}});
  }

  void light(const Vec2d& at, const Tint& tint) {
    for (int k = 0; k < 8; ++k) {
      const double angle = k * 0.7854;
      const Vec2d outwards(std::cos(angle), std::sin(angle));
      painter_.line(at + outwards * painter_.px(7), at + outwards * painter_.px(11), {tint, 2});
    }
    painter_.circle(at, painter_.px(light_radius), {tint, Stroke{}});
  }

  Painter& painter_;
  const PaintArea& area_;
  const SpaceProjection& projection_;
  const Image<float>& depth_;
  const SpaceLook& look_;
  bool bright_ = false;
  std::vector<Vec2d> corners_;
  std::vector<PaintArea> labels_;
};

}  // namespace

SpaceDrawn draw_space(Painter& painter, const PaintArea& area, const SpaceModel& model,
                      const SpaceProjection& projection, const Image<float>& depth, const SpaceLook& look) {
  SpaceDrawing drawing(painter, area, projection, depth, look);
  painter.begin_clip(area);
  for_each_shown(model, look, [&](const SpaceItem& item) { drawing.draw(item); });
  for (const bool bright : {true, false})
    for (const SpaceItem& item : model.items)
      if (is_shown(item, look) && (item.event >= 0 && item.event == look.highlighted) == bright) drawing.label(item);
  painter.end_clip();
  return drawing.drawn;
}

std::string space_svg(const SpaceModel& model, const SpacePicture& picture, const SpaceLook& look) {
  const PaintArea area{{0, 0}, {picture.levels.width(), picture.levels.height()}};
  SvgPainter svg(area.width(), area.height(), "The scene from outside, with the rays or triangles of one pixel");
  svg.picture(area, paled(picture, model.ground, {255, 255, 255}));
  draw_space(svg, area, model, SpaceProjection(picture.view, Settings{}, picture.near), picture.depth, look);
  return svg.finish();
}

}  // namespace ps
