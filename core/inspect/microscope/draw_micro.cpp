#include <vector>

#include "inspect/microscope/drawing.h"

namespace ps {
namespace {

/// Dark with a bright rim, so that it can be seen over any picture.
constexpr Tint ink{Role::dark}, rim{Role::bright, 0.84}, grid_tint{Role::own, 0.35, {128, 128, 128}},
    border_tint{Role::own, 0.75, {128, 128, 128}};
constexpr double rim_width = 1.6;  // pixels at scale 1, as below
constexpr double strong_edge = 3.2, edge = 1.6, sample_radius = 7, dot_radius = 4;
constexpr double point_arm = 16, place_arm = 9, gap_share = 0.4;  // of the arm, without a line

class MicroPainter {
 public:
  MicroPainter(Painter& painter, const MicroDrawing& drawing, const PaintArea& area)
      : painter_(painter), drawing_(drawing), area_(area) {}

  void draw(const MicroItem& item) {
    corners_.clear();
    for (const Vec2d& point : item.points) corners_.push_back(micro_place(drawing_, area_, point));
    switch (item.shape) {
    case MicroShape::line:
      return line(item);
    case MicroShape::outline:
      return outline(item);
    case MicroShape::dot:
      return dot(item);
    case MicroShape::words:
      return words(corners_.front(), item.label, item.emphasised ? Lettering::strong : Lettering::body);
    }
  }

 private:
  void rimmed(double width, Dash dash) {
    painter_.polyline(corners_, {rim, width + 2 * rim_width});
    painter_.polyline(corners_, {ink, width, dash});
  }

  void line(const MicroItem& item) {
    const double width = item.emphasised ? strong_edge : edge;
    switch (item.kind) {
    case MicroKind::grid:
      return painter_.polyline(corners_, {grid_tint, 1});
    case MicroKind::neighbour:
      return painter_.polyline(corners_, {border_tint, 1.4});
    case MicroKind::edge_not_owned:
      return rimmed(width, dashed);
    case MicroKind::owner_mark:
      painter_.polyline(corners_, {rim, width + rim_width});
      return painter_.polyline(corners_, {ink, width * 0.7});
    case MicroKind::edge_owned:
    case MicroKind::pixel:
    case MicroKind::corner:
    case MicroKind::sample_lit:
    case MicroKind::sample_unlit:
    case MicroKind::point:
    case MicroKind::triangle_name:
    case MicroKind::footprint:
    case MicroKind::tap:
    case MicroKind::place:
      return rimmed(width, solid);
    }
  }

  void outline(const MicroItem& item) {
    const bool footprint = item.kind == MicroKind::footprint;  // bright, so that its rim is dark
    const double width = item.kind == MicroKind::pixel ? 2.4 : footprint ? 2.2 : 1.6;
    painter_.polygon(corners_, {.stroke = Stroke{footprint ? Tint{Role::dark, 0.6} : rim, width + 2 * rim_width}});
    painter_.polygon(corners_, {.stroke = Stroke{footprint ? Tint{Role::attention} : ink, width}});
  }

  void dot(const MicroItem& item) {
    const Vec2d at = corners_.front();
    const Tint inside = item.on_dark ? Tint{Role::bright} : ink, outside = item.on_dark ? ink : rim;
    switch (item.kind) {
    case MicroKind::corner: {
      const Vec2d half(painter_.px(item.emphasised ? 5 : 4)), border(painter_.px(1.5));
      painter_.rectangle({at - half - border, at + half + border}, {.fill = rim});
      return painter_.rectangle({at - half, at + half}, {.fill = ink});
    }
    case MicroKind::sample_lit:
      return painter_.circle(at, painter_.px(sample_radius), {inside, Stroke{outside, 2}});
    case MicroKind::sample_unlit:
      painter_.circle(at, painter_.px(sample_radius - 1), {.stroke = Stroke{outside, 5}});
      return painter_.circle(at, painter_.px(sample_radius - 1), {.stroke = Stroke{inside, 2}});
    case MicroKind::point:
    case MicroKind::place:
      return cross(at, painter_.px(item.kind == MicroKind::point ? point_arm : place_arm));
    case MicroKind::grid:
    case MicroKind::neighbour:
    case MicroKind::pixel:
    case MicroKind::edge_owned:
    case MicroKind::edge_not_owned:
    case MicroKind::owner_mark:
    case MicroKind::triangle_name:
    case MicroKind::footprint:
    case MicroKind::tap:
      return painter_.circle(at, painter_.px(dot_radius), {.fill = ink});
    }
  }

  void cross(const Vec2d& at, double arm) {
    for (const Stroke& stroke : {Stroke{ink, 5}, Stroke{{Role::attention}, 2}})
      for (const Vec2d& along : {Vec2d(arm, 0), Vec2d(-arm, 0), Vec2d(0, arm), Vec2d(0, -arm)})
        painter_.line(at + along * gap_share, at + along, stroke);
  }

  void words(const Vec2d& at, const std::string& text, Lettering lettering) {
    painter_.text(at, text, {lettering, TextAnchor::middle, TextLevel::middle, ink, TextGround::plate, rim});
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
