#include "gui/panels/pictures/gizmo_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gui/base/record.h"
#include "gui/panels/pictures/marks.h"
#include "gui/session/handles.h"

namespace ps::gui {
namespace {

// Window pixels at scale 1.
constexpr double grip_reach = 9, line_reach = 6;  // within which a part is taken
constexpr double least_arrow = 16;                // shorter ones point at the eye
// Shares of the arrow's length.
constexpr double square_at = 1.32, ring_radius = 0.72;
constexpr int ring_steps = 48;

constexpr std::array object_axes{"x", "y", "z"}, camera_axes{"right", "up", "forward"};

/// Red, green and blue, as in other programs; light enough for a dark rim.
constexpr std::array axis_colours{IM_COL32(255, 110, 110, 255), IM_COL32(120, 235, 120, 255),
                                  IM_COL32(140, 180, 255, 255)};

const char* axis_name(const Gizmo& gizmo, std::size_t axis) {
  return gizmo.object ? object_axes.at(axis) : camera_axes.at(axis);
}

float distance(ImVec2 a, ImVec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

float distance_to_line(ImVec2 point, ImVec2 from, ImVec2 to) {
  const ImVec2 way{to.x - from.x, to.y - from.y};
  const float square = way.x * way.x + way.y * way.y;
  const float share = square > 0 ? ((point.x - from.x) * way.x + (point.y - from.y) * way.y) / square : 0;
  const float at = std::clamp(share, 0.f, 1.f);
  return distance(point, {from.x + way.x * at, from.y + way.y * at});
}

void draw_grip(ImDrawList& list, const GizmoMark& mark, const Gizmo& gizmo, bool held) {
  const float size = px(held ? 7 : 5);
  const ImVec2 at = mark.grip;
  const ImU32 light = axis_colours.at(mark.part.axis);
  switch (mark.part.deed) {
  case GizmoDeed::move: {
    const ImVec2 from = mark.line.front();
    const float length = std::max(distance(from, at), 1.f);
    const ImVec2 way{(at.x - from.x) / length, (at.y - from.y) / length};
    const auto head = [&](float grow, ImU32 colour) {
      list.AddTriangleFilled({at.x + way.x * (size + grow), at.y + way.y * (size + grow)},
                             {at.x - way.x * size - way.y * (size + grow), at.y - way.y * size + way.x * (size + grow)},
                             {at.x - way.x * size + way.y * (size + grow), at.y - way.y * size - way.x * (size + grow)},
                             colour);
    };
    head(px(2), IM_COL32(0, 0, 0, 190));
    head(0, light);
    ImFont* font = theme().font(Face::small);
    const char* name = axis_name(gizmo, mark.part.axis);
    const ImVec2 text{at.x + way.x * px(9) + px(4), at.y + way.y * px(9) - font->FontSize / 2};
    for (const ImVec2 by : {ImVec2{-1, 0}, ImVec2{1, 0}, ImVec2{0, -1}, ImVec2{0, 1}})
      list.AddText(font, font->FontSize, {text.x + by.x, text.y + by.y}, IM_COL32(0, 0, 0, 220), name);
    list.AddText(font, font->FontSize, text, light, name);
    break;
  }
  case GizmoDeed::turn:
    list.AddCircleFilled(at, size, IM_COL32(0, 0, 0, 190));
    list.AddCircleFilled(at, size - px(2), light);
    break;
  case GizmoDeed::scale:
    list.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, IM_COL32(0, 0, 0, 190));
    list.AddRectFilled({at.x - size + px(1.5), at.y - size + px(1.5)}, {at.x + size - px(1.5), at.y + size - px(1.5)},
                       light);
    break;
  }
}

std::string words_of(const Gizmo& gizmo, GizmoPart part) {
  return fmt::format("{} {} {} {}", deed_word(part.deed), gizmo.name, part.deed == GizmoDeed::turn ? "about" : "along",
                     axis_name(gizmo, part.axis));
}

}  // namespace

std::optional<ShownGizmo> shown_gizmo(const Gizmo& gizmo, const Sight& sight, const PictureToWindow& to_window) {
  const auto reach = world_length(sight, gizmo.centre, static_cast<double>(px(to_window.arrow)) / to_window.zoom);
  if (!reach || !(*reach > 0) || !std::isfinite(*reach)) return {};
  ShownGizmo shown{gizmo, *reach, {}};
  const auto at = [&](const Vec3d& point) -> std::optional<ImVec2> {
    const auto place = place_in_picture(sight.view, sight.settings, point);
    if (!place) return {};
    return to_window.point(*place);
  };
  const auto centre = at(gizmo.centre);
  if (!centre) return {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto tip = at(gizmo.centre + gizmo.axes[axis] * *reach);
    if (!tip || distance(*centre, *tip) < px(least_arrow)) continue;
    shown.marks.push_back({{GizmoDeed::move, axis}, *tip, {*centre, *tip}});
    const auto square = at(gizmo.centre + gizmo.axes[axis] * (*reach * square_at));
    if (gizmo.scales && square) shown.marks.push_back({{GizmoDeed::scale, axis}, *square, {}});
  }
  for (std::size_t axis = 0; gizmo.turns && axis < 3; ++axis) {
    const Vec3d u = gizmo.axes[(axis + 1) % 3] * (*reach * ring_radius),
                v = gizmo.axes[(axis + 2) % 3] * (*reach * ring_radius);
    GizmoMark ring{{GizmoDeed::turn, axis}, {}, {}};
    bool whole = true;
    for (int i = 0; i <= ring_steps && whole; ++i) {
      const double angle = 2 * std::numbers::pi * i / ring_steps;
      const auto point = at(gizmo.centre + u * std::cos(angle) + v * std::sin(angle));
      whole = point.has_value();
      if (point) ring.line.push_back(*point);
    }
    if (!whole) continue;
    ring.grip = ring.line[ring_steps / 8];  // between two arrows
    shown.marks.push_back(std::move(ring));
  }
  return shown;
}

const GizmoMark* mark_at(const ShownGizmo& shown, ImVec2 point) {
  const GizmoMark* nearest = nullptr;
  float least = px(grip_reach);
  for (const GizmoMark& mark : shown.marks)
    if (const float away = distance(mark.grip, point); away <= least) {
      least = away;
      nearest = &mark;
    }
  if (nearest) return nearest;
  least = px(line_reach);
  for (const GizmoMark& mark : shown.marks)
    for (std::size_t i = 0; i + 1 < mark.line.size(); ++i)
      if (const float away = distance_to_line(point, mark.line[i], mark.line[i + 1]); away <= least) {
        least = away;
        nearest = &mark;
      }
  return nearest;
}

void draw_gizmo(ImDrawList& list, const ShownGizmo& shown, const std::optional<GizmoPart>& held, const Area& clip) {
  list.PushClipRect(clip.min, clip.max, true);
  const GizmoMark* named = nullptr;
  for (const GizmoMark& mark : shown.marks) {
    const bool is_held = held == mark.part;
    if (is_held) named = &mark;
    if (!mark.line.empty())
      light_on_dark(
          is_held,
          [&](ImU32 colour, float thickness) {
            list.AddPolyline(mark.line.data(), static_cast<int>(mark.line.size()), colour, ImDrawFlags_None, thickness);
          },
          axis_colours.at(mark.part.axis));
  }
  for (const GizmoMark& mark : shown.marks) draw_grip(list, mark, shown.gizmo, held == mark.part);
  if (named) name_plate(list, words_of(shown.gizmo, named->part), named->grip, 22, clip);
  list.PopClipRect();
}

std::string part_key(const Gizmo& gizmo, GizmoPart part) {
  return fmt::format("{}/{}", deed_word(part.deed), axis_name(gizmo, part.axis));
}

void record_gizmo(const std::string& prefix, const ShownGizmo& shown, const Area& clip) {
  for (const GizmoMark& mark : shown.marks) {
    if (!clip.contains(mark.grip)) continue;
    const float half = px(4);
    controls().record(prefix + "/" + part_key(shown.gizmo, mark.part), {mark.grip.x - half, mark.grip.y - half},
                      {mark.grip.x + half, mark.grip.y + half}, words_of(shown.gizmo, mark.part));
  }
}

}  // namespace ps::gui
