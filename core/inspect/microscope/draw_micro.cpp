#include <vector>

#include "inspect/microscope/drawing.h"

namespace ps {
namespace {

/// Dark with a bright rim, so that it can be seen over any picture.
constexpr Tint micro_ink{Role::dark}, micro_rim{Role::bright, 0.84}, grid_tint{Role::own, 0.35, {128, 128, 128}},
    border_tint{Role::own, 0.75, {128, 128, 128}};
constexpr double micro_rim_width = 1.6;  // pixels at scale 1, as below
constexpr double strong_edge_width = 3.2, edge_width = 1.6, sample_radius = 7;
constexpr double point_arm = 16, place_arm = 9, gap_share = 0.4;  // of the arm, without a line

class MicroPainter {
 public:
  MicroPainter(Painter& painter, const MicroDrawing& drawing, const PaintArea& area)
      : painter_(painter), drawing_(drawing), area_(area) {}

  void draw(const MicroItem& item) {
    corners_.clear();
    for (const Vec2d& point : item.points) corners_.push_back(micro_place(drawing_, area_, point));
    const Vec2d at = corners_.front();
    const double width = item.emphasised ? strong_edge_width : edge_width, radius = painter_.px(sample_radius);
    const Tint inside = item.on_dark ? Tint{Role::bright} : micro_ink, outside = item.on_dark ? micro_ink : micro_rim;
    switch (item.kind) {
    case MicroKind::grid:
      return painter_.polyline(corners_, {grid_tint, 1});
    case MicroKind::neighbour:
      return painter_.polyline(corners_, {border_tint, 1.4});
    case MicroKind::pixel:
      return outline(micro_ink, 2.4, micro_rim);
    case MicroKind::edge_owned:
    case MicroKind::edge_not_owned:
      painter_.polyline(corners_, {micro_rim, width + 2 * micro_rim_width});
      return painter_.polyline(corners_, {micro_ink, width, item.kind == MicroKind::edge_owned ? unbroken : dashed});
    case MicroKind::owner_mark:
      painter_.polyline(corners_, {micro_rim, width + micro_rim_width});
      return painter_.polyline(corners_, {micro_ink, width * 0.7});
    case MicroKind::corner: {
      const Vec2d half(painter_.px(item.emphasised ? 5 : 4)), border(painter_.px(1.5));
      painter_.rectangle({at - half - border, at + half + border}, {.fill = micro_rim});
      return painter_.rectangle({at - half, at + half}, {.fill = micro_ink});
    }
    case MicroKind::sample_lit:
      return painter_.circle(at, radius, {inside, Stroke{outside, 2}});
    case MicroKind::sample_unlit:
      for (const Stroke& ring : {Stroke{outside, 5}, Stroke{inside, 2}}) painter_.circle(at, radius, {.stroke = ring});
      return;
    case MicroKind::point:
      return cross(at, painter_.px(point_arm));
    case MicroKind::place:
      return cross(at, painter_.px(place_arm));
    case MicroKind::footprint:  // bright, so that its rim is dark
      return outline({Role::attention}, 2.2, {Role::dark, 0.6});
    case MicroKind::tap:
      if (item.shape == MicroShape::outline) return outline(micro_ink, 1.6, micro_rim);
      return words(at, item);
    case MicroKind::triangle_name:
      return words(at, item);
    }
  }

 private:
  void outline(const Tint& tint, double width, const Tint& beside) {
    painter_.polygon(corners_, {.stroke = Stroke{beside, width + 2 * micro_rim_width}});
    painter_.polygon(corners_, {.stroke = Stroke{tint, width}});
  }

  void cross(const Vec2d& at, double arm) {
    for (const Stroke& stroke : {Stroke{micro_ink, 5}, Stroke{{Role::attention}, 2}})
      for (const Vec2d& along : {Vec2d(arm, 0), Vec2d(-arm, 0), Vec2d(0, arm), Vec2d(0, -arm)})
        painter_.line(at + along * gap_share, at + along, stroke);
  }

  void words(const Vec2d& at, const MicroItem& item) {
    painter_.text(at, item.label,
                  {item.emphasised ? Lettering::strong : Lettering::body, TextAnchor::middle, TextLevel::middle,
                   micro_ink, TextGround::plate, micro_rim});
  }

  Painter& painter_;
  const MicroDrawing& drawing_;
  const PaintArea& area_;
  std::vector<Vec2d> corners_;
};

}  // namespace

Vec2d micro_place(const MicroDrawing& drawing, const PaintArea& area, const Vec2d& point) {
  return area.low + (point - drawing.low) / (drawing.high - drawing.low) * (area.high - area.low);
}

Vec2d micro_point(const MicroDrawing& drawing, const PaintArea& area, const Vec2d& place) {
  return drawing.low + (place - area.low) / (area.high - area.low) * (drawing.high - drawing.low);
}

void draw_micro(Painter& painter, const MicroDrawing& drawing, const PaintArea& area) {
  painter.begin_clip(area);
  painter.picture(area, drawing.backdrop);
  MicroPainter micro(painter, drawing, area);
  for (const MicroItem& item : drawing.items) micro.draw(item);
  painter.end_clip();
}

}  // namespace ps
