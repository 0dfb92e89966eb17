#include "gui/panels/microscope/micro_paint.h"

#include <algorithm>
#include <cmath>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

/// Ink that can be seen on any backdrop: a dark line with a light rim.
constexpr ImU32 ink = IM_COL32(24, 24, 24, 255), rim = IM_COL32(255, 255, 255, 215);
constexpr ImU32 light_colour =
    IM_COL32(255, 255, 255, 255);  // for samples, which are filled in what parts from the backdrop
constexpr float rim_width = 1.6f;

class MicroPainter {
 public:
  MicroPainter(ImDrawList& list, const MicroDrawing& drawing, const Area& area)
      : list_(list), drawing_(drawing), area_(area) {}

  void draw(const MicroItem& item) {
    switch (item.shape) {
    case MicroShape::line:
      line(item);
      break;
    case MicroShape::outline:
      outline(item);
      break;
    case MicroShape::dot:
      dot(item);
      break;
    case MicroShape::words:
      words(place(item.points[0]), item.label, item.emphasised ? Face::bold : Face::body);
      break;
    }
  }

 private:
  ImVec2 place(const Vec2d& point) const { return micro_place(drawing_, area_, point); }

  void stroke(ImVec2 a, ImVec2 b, float width) {
    list_.AddLine(a, b, rim, px(width + 2 * rim_width));
    list_.AddLine(a, b, ink, px(width));
  }

  void dashes(ImVec2 a, ImVec2 b, float width) {
    const float length = std::hypot(b.x - a.x, b.y - a.y), step = px(13);
    list_.AddLine(a, b, rim, px(width + 2 * rim_width));
    for (float at = 0; at < length; at += step) {
      const float end = std::min(length, at + step * 0.6f);
      const auto on = [&](float d) { return ImVec2{a.x + (b.x - a.x) * d / length, a.y + (b.y - a.y) * d / length}; };
      list_.AddLine(on(at), on(end), ink, px(width));
    }
  }

  void line(const MicroItem& item) {
    const ImVec2 a = place(item.points[0]), b = place(item.points[1]);
    const float width = item.emphasised ? 3.2f : 1.6f;
    switch (item.kind) {
    case MicroKind::grid:
      list_.AddLine(a, b, IM_COL32(128, 128, 128, 90), px(1));
      return;
    case MicroKind::neighbour:
      list_.AddLine(a, b, IM_COL32(90, 90, 90, 190), px(1.4));
      return;
    case MicroKind::edge_not_owned:
      return dashes(a, b, width);
    case MicroKind::owner_mark:
      list_.AddLine(a, b, rim, px(width + rim_width));
      list_.AddLine(a, b, ink, px(width * 0.7f));
      return;
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
      return stroke(a, b, width);
    }
  }

  void outline(const MicroItem& item) {
    std::vector<ImVec2> corners;
    for (const Vec2d& point : item.points) corners.push_back(place(point));
    const int count = static_cast<int>(corners.size());
    const float width = item.kind == MicroKind::pixel ? 2.4f : item.kind == MicroKind::footprint ? 2.2f : 1.6f;
    list_.AddPolyline(corners.data(), count, rim, ImDrawFlags_Closed, px(width + 2 * rim_width));
    list_.AddPolyline(corners.data(), count, item.kind == MicroKind::footprint ? colour_u32(palette().attention) : ink,
                      ImDrawFlags_Closed, px(width));
    if (item.label.empty()) return;
    const Vec2d middle = (item.points[0] + item.points[2]) / 2.0;
    words(place(middle), item.label, Face::small);
  }

  void dot(const MicroItem& item) {
    const ImVec2 at = place(item.points[0]);
    switch (item.kind) {
    case MicroKind::corner: {
      const float half = px(item.emphasised ? 5 : 4);
      list_.AddRectFilled({at.x - half - px(1.5), at.y - half - px(1.5)},
                          {at.x + half + px(1.5), at.y + half + px(1.5)}, rim);
      list_.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, ink);
      return;
    }
    case MicroKind::sample_lit:
      list_.AddCircleFilled(at, px(8), item.on_dark ? ink : rim);
      list_.AddCircleFilled(at, px(6), item.on_dark ? light_colour : ink);
      return;
    case MicroKind::sample_unlit:
      list_.AddCircle(at, px(6), item.on_dark ? ink : rim, 24, px(5));
      list_.AddCircle(at, px(6), item.on_dark ? light_colour : ink, 24, px(2));
      return;
    case MicroKind::point:
    case MicroKind::place: {
      const float arm = px(item.kind == MicroKind::point ? 16 : 9);
      const ImU32 bright = colour_u32(palette().attention);
      for (const float width : {px(5), px(2)}) {
        const ImU32 colour = width > px(3) ? ink : bright;
        for (const float side : {-1.f, 1.f}) {
          const float from = side * arm * 0.4f, to = side * arm;
          list_.AddLine({at.x + from, at.y}, {at.x + to, at.y}, colour, width);
          list_.AddLine({at.x, at.y + from}, {at.x, at.y + to}, colour, width);
        }
      }
      return;
    }
    case MicroKind::grid:
    case MicroKind::neighbour:
    case MicroKind::pixel:
    case MicroKind::edge_owned:
    case MicroKind::edge_not_owned:
    case MicroKind::owner_mark:
    case MicroKind::triangle_name:
    case MicroKind::footprint:
    case MicroKind::tap:
      list_.AddCircleFilled(at, px(4), ink);
      return;
    }
  }

  void words(ImVec2 middle, const std::string& text, Face face) {
    ImFont* font = theme().font(face);
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str());
    const ImVec2 corner{middle.x - size.x / 2, middle.y - size.y / 2};
    list_.AddRectFilled({corner.x - px(4), corner.y - px(1)}, {corner.x + size.x + px(4), corner.y + size.y + px(1)},
                        rim, px(4));
    list_.AddText(font, font->FontSize, corner, ink, text.c_str());
  }

  ImDrawList& list_;
  const MicroDrawing& drawing_;
  const Area& area_;
};

}  // namespace

ImVec2 micro_place(const MicroDrawing& drawing, const Area& area, const Vec2d& point) {
  const Vec2d share = (point - drawing.low) / (drawing.high - drawing.low);
  return {area.min.x + static_cast<float>(share.x) * area.width(),
          area.min.y + static_cast<float>(share.y) * area.height()};
}

Vec2d micro_point(const MicroDrawing& drawing, const Area& area, ImVec2 place) {
  const Vec2d share((place.x - area.min.x) / area.width(), (place.y - area.min.y) / area.height());
  return drawing.low + share * (drawing.high - drawing.low);
}

void draw_micro(ImDrawList& list, const MicroDrawing& drawing, const Area& area, ImTextureID backdrop) {
  list.PushClipRect(area.min, area.max, true);
  list.AddImage(backdrop, area.min, area.max);
  MicroPainter painter(list, drawing, area);
  for (const MicroItem& item : drawing.items) painter.draw(item);
  list.PopClipRect();
}

}  // namespace ps::gui
