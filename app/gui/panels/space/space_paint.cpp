#include "gui/panels/space/space_paint.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

constexpr double reach = 7;        // how near the pointer must be, pixels at scale 1
constexpr int image_patches = 10;  // along each side; a patch is drawn without perspective
constexpr float hidden_alpha = 0.5f;

float distance_to(ImVec2 p, ImVec2 a, ImVec2 b) {
  const float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const float t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.f, 1.f) : 0.f;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

class Painter {
 public:
  Painter(ImDrawList& list, const Area& area, const SpaceProjection& projection, const Image<float>& depth,
          const SpaceLook& look, ImVec2 pointer)
      : list_(list), area_(area), projection_(projection), depth_(depth), look_(look), pointer_(pointer) {}

  void draw(const SpaceItem& item) {
    SpaceStroke stroke = stroke_of(item);
    bright_ = item.event >= 0 && item.event == look_.highlighted;
    item_ = &item;
    count(item);
    switch (item.shape) {
    case SpaceShape::line:
      line(item.points[0], item.points[1], stroke);
      if (item.kind == SpaceKind::shadow_ray_blocked) cross(item.points[1], stroke);
      break;
    case SpaceShape::arrow:
      line(item.points[0], item.points[1], stroke);
      head(item.points[0], item.points[1], stroke);
      break;
    case SpaceShape::outline:
      for (std::size_t i = 0; i < item.points.size(); ++i)
        line(item.points[i], item.points[(i + 1) % item.points.size()], stroke);
      break;
    case SpaceShape::area:
      fill(item, stroke);
      break;
    case SpaceShape::point:
      dot(item, stroke);
      break;
    case SpaceShape::box:
      box(item.points[0], item.points[1], stroke);
      break;
    }
  }

  void label(const SpaceItem& item) {
    const bool bright = item.event >= 0 && item.event == look_.highlighted;
    const bool always = item.kind == SpaceKind::light || item.kind == SpaceKind::frustum ||
                        item.kind == SpaceKind::shading_normal || item.kind == SpaceKind::clip_plane ||
                        (item.kind == SpaceKind::hit_point && item.event < 0);  // a vertex that is followed
    if (item.label.empty() || (!always && !bright)) return;
    Vec3d at = item.points.back();
    if (item.kind == SpaceKind::frustum) at = item.points.front();
    if (item.kind == SpaceKind::light) at = item.points.front();
    const auto place = projection_.point(at);
    if (!place) return;
    ImFont* font = theme().font(bright ? Face::bold : Face::small);
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, item.label.c_str());
    ImVec2 corner = window(*place);
    corner.x += px(9);
    corner.y -= size.y + px(3);
    if (corner.x + size.x > area_.max.x - px(4)) corner.x -= size.x + px(18);
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    for (const auto& [low, high] : labels_)
      if (corner.x < high.x && low.x < end.x && corner.y < high.y && low.y < end.y) return;
    labels_.emplace_back(corner, end);
    list_.AddRectFilled({corner.x - px(4), corner.y - px(1)}, {end.x + px(4), end.y + px(1)},
                        colour_u32(palette().panel, 0.82), px(4));
    list_.AddText(font, font->FontSize, corner, colour_u32(palette().text), item.label.c_str());
  }

  /// The picture itself on its plane, in patches small enough to look right in perspective.
  void image(const SpaceItem& plane) {
    const auto& c = plane.points;
    const auto at = [&](int x, int y) {
      const double u = static_cast<double>(x) / image_patches, v = static_cast<double>(y) / image_patches;
      return projection_.point((c[0] * (1 - u) + c[1] * u) * (1 - v) + (c[3] * (1 - u) + c[2] * u) * v);
    };
    constexpr float step = 1.f / image_patches;
    for (int y = 0; y < image_patches; ++y)
      for (int x = 0; x < image_patches; ++x) {
        const auto a = at(x, y), b = at(x + 1, y), d = at(x + 1, y + 1), e = at(x, y + 1);
        if (!a || !b || !d || !e) continue;
        const float u = static_cast<float>(x) * step, v = static_cast<float>(y) * step;
        list_.AddImageQuad(look_.picture->id(), window(*a), window(*b), window(*d), window(*e), {u, v}, {u + step, v},
                           {u + step, v + step}, {u, v + step}, IM_COL32(255, 255, 255, 205));
      }
  }

  SpaceDrawn drawn;

 private:
  ImVec2 window(const SpacePlace& place) const {
    return {area_.min.x + static_cast<float>(place.at.x), area_.min.y + static_cast<float>(place.at.y)};
  }

  void count(const SpaceItem& item) {
    ++drawn.items;
    const SpaceGroup group = group_of(item.kind);
    if (group == SpaceGroup::rays) ++drawn.rays;
    if (group == SpaceGroup::shadows) ++drawn.shadow_rays;
    if (group == SpaceGroup::nodes) ++drawn.boxes;
  }

  /// Remembers what is nearest to the pointer.
  void offer(float distance) {
    if (item_->event < 0 || distance > px(reach) || distance >= nearest_) return;
    nearest_ = distance;
    drawn.hovered = item_->event;
  }

  void line(const Vec3d& from, const Vec3d& to, const SpaceStroke& stroke) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    for (const SpaceRun& run : visible_runs(depth_, *seen)) {
      const ImVec2 a = window(run.from), b = window(run.to);
      offer(distance_to(pointer_, a, b));
      if (bright_) drawn.highlight_place = ImVec2{(a.x + b.x) / 2, (a.y + b.y) / 2};
      segment(a, b, stroke, run.hidden);
    }
  }

  void segment(ImVec2 a, ImVec2 b, const SpaceStroke& stroke, bool hidden) {
    const float width = std::max(1.f, px(hidden ? std::min(stroke.width, 1.2f) : stroke.width));
    const bool thin = stroke.width <= 1;
    if (bright_) list_.AddLine(a, b, colour_u32(palette().attention, hidden ? 0.5 : 0.95), width + px(6));
    const double alpha = (thin ? 0.45 : 1) * (hidden ? hidden_alpha : 1);
    if (!thin && !hidden && !stroke.dashed && !stroke.dotted)
      list_.AddLine(a, b, colour_u32(palette().panel, 0.75), width + px(2.5));
    const float on = stroke.dotted ? px(2.5) : hidden ? px(4) : px(8), off = stroke.dotted ? px(4) : px(5);
    if (hidden || stroke.dashed || stroke.dotted)
      dashes(a, b, colour_u32(stroke.colour, alpha), width, on, off);
    else
      list_.AddLine(a, b, colour_u32(stroke.colour, alpha), width);
  }

  void dashes(ImVec2 a, ImVec2 b, ImU32 colour, float width, float on, float off) {
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0) || length > 20000) return;
    const ImVec2 unit{(b.x - a.x) / length, (b.y - a.y) / length};
    for (float t = 0; t < length; t += on + off) {
      const float end = std::min(t + on, length);
      list_.AddLine({a.x + unit.x * t, a.y + unit.y * t}, {a.x + unit.x * end, a.y + unit.y * end}, colour, width);
    }
  }

  void head(const Vec3d& from, const Vec3d& to, const SpaceStroke& stroke) {
    const auto seen = projection_.line(from, to);
    if (!seen) return;
    const ImVec2 a = window(seen->from), b = window(seen->to);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < px(6)) return;
    const float size = std::min(px(5 + stroke.width), length / 2);
    const ImVec2 back{(a.x - b.x) / length * size, (a.y - b.y) / length * size};
    const bool hidden = is_hidden(depth_, seen->to);
    list_.AddTriangleFilled(b, {b.x + back.x * 1.5f - back.y * 0.6f, b.y + back.y * 1.5f + back.x * 0.6f},
                            {b.x + back.x * 1.5f + back.y * 0.6f, b.y + back.y * 1.5f - back.x * 0.6f},
                            colour_u32(stroke.colour, hidden ? hidden_alpha : 1));
  }

  void cross(const Vec3d& at, const SpaceStroke& stroke) {
    const auto place = projection_.point(at);
    if (!place) return;
    const ImVec2 c = window(*place);
    const float r = px(5);
    for (const float width : {px(5), px(2.4)}) {
      const ImU32 colour = width > px(3) ? colour_u32(palette().panel) : colour_u32(stroke.colour);
      list_.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, width);
      list_.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, width);
    }
  }

  void fill(const SpaceItem& item, const SpaceStroke& stroke) {
    const auto polygon = projection_.polygon(item.points);
    if (polygon.size() < 3) return;
    std::vector<ImVec2> corners;
    corners.reserve(polygon.size());
    for (const SpacePlace& place : polygon) corners.push_back(window(place));
    double alpha = 0.5;
    if (item.kind == SpaceKind::triangle_on_image) alpha = item.emphasised ? 0.25 : 0.1;
    if (item.kind == SpaceKind::pixel_cell) alpha = 1;
    if (item.kind == SpaceKind::shadow_volume) alpha = 0.08;
    list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), colour_u32(stroke.colour, alpha));
    for (std::size_t i = 0; i < corners.size(); ++i)
      list_.AddLine(corners[i], corners[(i + 1) % corners.size()],
                    colour_u32(stroke.colour, item.kind == SpaceKind::shadow_volume ? 0.3 : 0.9), px(1.2));
    if (item.kind == SpaceKind::pixel_cell)  // a pixel is small: a ring says where it is
      list_.AddCircle(corners[0], px(6), colour_u32(palette().text), 0, px(1.6));
  }

  void dot(const SpaceItem& item, const SpaceStroke& stroke) {
    const auto place = projection_.point(item.points[0]);
    if (!place) return;
    const ImVec2 c = window(*place);
    offer(std::hypot(pointer_.x - c.x, pointer_.y - c.y) * 0.6f);  // points win over the lines that end in them
    if (bright_) {
      drawn.highlight_place = c;
      list_.AddCircleFilled(c, px(9), colour_u32(palette().attention));
    }
    if (item.kind == SpaceKind::light) {
      for (int k = 0; k < 8; ++k) {
        const float angle = static_cast<float>(k) * 0.7854f, x = std::cos(angle), y = std::sin(angle);
        list_.AddLine({c.x + x * px(7), c.y + y * px(7)}, {c.x + x * px(11), c.y + y * px(11)},
                      colour_u32(stroke.colour), px(2));
      }
      list_.AddCircleFilled(c, px(5), colour_u32(stroke.colour));
      list_.AddCircle(c, px(5), colour_u32(palette().text), 0, px(1));
      return;
    }
    const bool hidden = is_hidden(depth_, *place);
    list_.AddCircleFilled(c, px(5), colour_u32(palette().panel, hidden ? hidden_alpha : 1));
    if (item.emphasised)
      list_.AddCircleFilled(c, px(3.6), colour_u32(stroke.colour, hidden ? hidden_alpha : 1));
    else
      list_.AddCircle(c, px(3.6), colour_u32(stroke.colour), 0, px(1.4));
  }

  void box(const Vec3d& low, const Vec3d& high, const SpaceStroke& stroke) {
    const auto corner = [&](int k) {
      return Vec3d((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y, (k & 4) != 0 ? high.z : low.z);
    };
    for (int k = 0; k < 8; ++k)
      for (const int bit : {1, 2, 4})
        if ((k & bit) == 0) line(corner(k), corner(k | bit), stroke);
  }

  ImDrawList& list_;
  const Area& area_;
  const SpaceProjection& projection_;
  const Image<float>& depth_;
  const SpaceLook& look_;
  ImVec2 pointer_;
  const SpaceItem* item_ = nullptr;
  bool bright_ = false;
  float nearest_ = 1e30f;
  std::vector<std::pair<ImVec2, ImVec2>> labels_;
};

/// Faint things first, what matters on top.
int layer(const SpaceItem& item, const SpaceLook& look) {
  if (item.event >= 0 && item.event == look.highlighted) return 4;
  switch (item.shape) {
  case SpaceShape::box:
    return 0;
  case SpaceShape::area:
    return item.kind == SpaceKind::pixel_cell ? 2 : 1;
  case SpaceShape::line:
  case SpaceShape::arrow:
  case SpaceShape::outline:
    return item.event < 0 ? 0 : 2;
  case SpaceShape::point:
    return 3;
  }
  return 2;
}

}  // namespace

bool is_shown(const SpaceItem& item, const SpaceLook& look) {
  const SpaceGroup group = group_of(item.kind);
  if (!look.groups[static_cast<std::size_t>(group)]) return false;
  if (look.up_to_event >= 0 && item.event > look.up_to_event) return false;
  if (group == SpaceGroup::nodes) return item.level <= look.deepest_level;
  if (item.contribution < look.least_contribution && group != SpaceGroup::rejected) return false;
  return true;
}

SpaceDrawn draw_space(ImDrawList& list, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                      const Image<float>& depth, const SpaceLook& look, ImVec2 pointer) {
  Painter painter(list, area, projection, depth, look, pointer);
  list.PushClipRect(area.min, area.max, true);
  for (const SpaceItem& item : model.items)
    if (item.kind == SpaceKind::image_plane && is_shown(item, look) && look.picture && !look.picture->empty())
      painter.image(item);
  for (int wanted = 0; wanted <= 4; ++wanted)
    for (const SpaceItem& item : model.items)
      if (is_shown(item, look) && layer(item, look) == wanted) painter.draw(item);
  for (const bool bright : {true, false})
    for (const SpaceItem& item : model.items)
      if (is_shown(item, look) && (item.event >= 0 && item.event == look.highlighted) == bright) painter.label(item);
  list.PopClipRect();
  return painter.drawn;
}

}  // namespace ps::gui
