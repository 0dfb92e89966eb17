#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/quoted_line.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/shorten.h"

namespace ps::gui {
namespace {

constexpr double tooltip_delay = 0.6;  // seconds at rest

/// What the pointer rests on, by the rectangle of the item: items without an id have tooltips too.
struct Rest {
  ImVec2 min{-1, -1}, max{-1, -1};
  double since = 0;
  bool shown = false, hidden = false;  ///< hidden: by a key, until the pointer goes on
};
Rest rest;

bool rested_on_last_item() {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const double now = ImGui::GetTime();
  const bool same = rest.min.x == min.x && rest.min.y == min.y && rest.max.x == max.x && rest.max.y == max.y;
  const bool moving = (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) && now - rest.since < tooltip_delay;
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (!same || moving || (rest.hidden && moved) || ImGui::IsAnyMouseDown() || io.MouseWheel != 0)
    rest = {min, max, now};
  if (rest.hidden) return false;
  const double left = tooltip_delay - (now - rest.since);
  if (left > 0) redraw_after(left + 0.005);
  // Dear ImGui hides a window that sizes itself in its first frame.
  if (left <= 0 && !std::exchange(rest.shown, true)) redraw_after(0);
  return left <= 0;
}

}  // namespace

void hide_tooltip() { rest.hidden = true; }

namespace {

ImGuiWindow* tooltip_window() { return ImGui::FindWindowByName("##Tooltip_00"); }

}  // namespace

bool tooltip_visible() {
  const ImGuiWindow* window = tooltip_window();
  return window && window->Active && !window->Hidden;
}

double tooltip_end() { return tooltip_visible() ? tooltip_window()->Pos.x + tooltip_window()->Size.x : 0; }

namespace {

/// As large as its contents of the frame before; in its first frame a tooltip is hidden and has none.
ImVec2 tooltip_size() {
  ImGuiWindow* window = tooltip_window();
  return window ? ImGui::CalcWindowNextAutoFitSize(window) : ImVec2{0, 0};
}

/// Below the item and flush with its left edge, above it where there is no room below, so that neither the item nor
/// what is beside it is covered. Over a large one, such as a picture, Dear ImGui places it beside the pointer.
void place_beside_last_item() {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax(), display = ImGui::GetIO().DisplaySize;
  if (max.y - min.y > 5 * ImGui::GetFrameHeight()) return;
  const ImVec2 size = tooltip_size();
  const float away = px(5);
  const float left = std::clamp(min.x, 0.f, std::max(0.f, display.x - size.x));
  const bool room_below = max.y + away + size.y <= display.y;
  ImGui::SetNextWindowPos({left, room_below ? max.y + away : std::max(0.f, min.y - away - size.y)});
}

/// Never wider than the window, with room for its margins.
float tooltip_width() { return std::min(ImGui::GetFontSize() * 38, ImGui::GetIO().DisplaySize.x - px(40)); }

}  // namespace

bool begin_tooltip() {
  if (!rested_on_last_item()) return false;
  place_beside_last_item();
  begin_tooltip_at_pointer();
  return true;
}

void begin_tooltip_at_pointer() {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(8)});
  ImGui::BeginTooltip();
  ImGui::PushFont(theme().font(Face::body));
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + tooltip_width());  // it counts from the window's edge
}

void end_tooltip() {
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void tooltip(std::string_view text) {
  if (text.empty() || !begin_tooltip()) return;
  ImGui::TextUnformatted(in_lines(text, tooltip_width()).c_str());
  end_tooltip();
}

bool progress_bar(std::string_view name, std::string_view label, double fraction, float width) {
  const Palette& p = palette();
  const NameScope names(name);
  const float cancel_width = px(74), room = full_width({.width = width});
  const float bar = std::max(px(40), room - cancel_width - ImGui::GetStyle().ItemSpacing.x);
  ImGui::Dummy({bar, ImGui::GetFrameHeight()});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = max.y - px(5);
  draw.AddRectFilled({min.x, y}, {max.x, y + px(3)}, colour_u32(p.line), px(2));
  const float share = static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  draw.AddRectFilled({min.x, y}, {min.x + (max.x - min.x) * share, y + px(3)}, colour_u32(p.text_quiet), px(2));
  const std::string percent = fraction < 0 ? "" : std::to_string(static_cast<int>(share * 100)) + " %";
  const float end = max.x - (percent.empty() ? 0 : px(60));
  draw_text(min, {end, y}, whole_words(label, end - min.x), p.text, 0);
  draw_text({max.x - px(60), min.y}, {max.x, y}, percent, p.text_quiet, 1, Face::mono);
  controls().record("bar", percent);
  ImGui::SameLine();
  return button("cancel", "Cancel", Emphasis::plain, {.width = cancel_width});
}

namespace {

/// Draws a message where there is a list to draw into: sentences in lines of this width, and lines that quote a file as
/// they are, in letters of one width. Gives the height.
float message_lines(ImDrawList* draw, ImVec2 at, std::string_view text, float width) {
  float height = 0;
  for (bool more = true; more;) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    more = end < text.size();
    text.remove_prefix(more ? end + 1 : end);
    const bool quoted = line.starts_with(quotation_indent);
    const FontScope font(quoted ? std::optional(Face::mono) : std::nullopt);
    const std::string shown = quoted ? std::string(line) : in_lines(line, width);
    if (draw) draw->AddText({at.x, at.y + height}, colour_u32(palette().text), shown.c_str());
    height += text_height(shown);
  }
  return height;
}

}  // namespace

bool message_bar(std::string_view name, MessageKind kind, std::string_view text) {
  const Palette& p = palette();
  const NameScope names(name);
  const ImVec4 accent = kind == MessageKind::error     ? p.wrong_mark
                        : kind == MessageKind::warning ? p.attention
                                                       : p.line_strong;
  const std::string_view mark = kind == MessageKind::error ? "Error" : kind == MessageKind::warning ? "Note" : "";
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const float button_width = px(86), inset = px(14);
  const float mark_width = mark.empty() ? 0 : text_width(mark, Face::bold) + px(10);
  const float wrap = std::max(px(80), room - button_width - 2 * inset - mark_width);
  const float words = message_lines(nullptr, {}, text, wrap);
  const float height = std::max(words, ImGui::GetFrameHeight()) + px(10);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 end{start.x + room, start.y + height};
  draw.AddRectFilled(start, end, colour_u32(p.field));
  draw.AddRectFilled(start, {start.x + px(5), end.y}, colour_u32(accent));
  if (kind == MessageKind::warning) attention_bar(draw, start, {start.x + px(5), end.y});
  const float y = start.y + (height - words) / 2;
  if (!mark.empty()) {
    const FontScope bold(Face::bold);
    draw.AddText({start.x + inset, y}, colour_u32(p.text), mark.data(), mark.data() + mark.size());
  }
  message_lines(&draw, {start.x + inset + mark_width, y}, text, wrap);
  // In sight also where the window cuts a long text off.
  const float above = std::min((height - ImGui::GetFrameHeight()) / 2, 2 * ImGui::GetFrameHeight());
  ImGui::SetCursorScreenPos({end.x - button_width - px(5), start.y + above});
  const bool dismissed = button("dismiss", "Dismiss", Emphasis::plain, {.width = button_width});
  ImGui::SetCursorScreenPos(start);
  ImGui::Dummy({room, height});
  controls().record("text", start, {end.x - button_width - inset, end.y}, std::string(text));
  return dismissed;
}

Edit splitter(std::string_view name, SplitterAxis axis, float length, float& position, float minimum, float maximum) {
  const Palette& p = palette();
  const float thickness = std::floor(px(6));
  const bool upright = axis == SplitterAxis::left_right;
  const ImVec2 size = upright ? ImVec2{thickness, length} : ImVec2{length, thickness};
  hit_area(name, size, {});
  Edit edit;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered())
    ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  static float grabbed_at = 0;  // one splitter is dragged at a time
  const float pointer = upright ? ImGui::GetIO().MousePos.x : ImGui::GetIO().MousePos.y;
  if (ImGui::IsItemActivated()) grabbed_at = pointer - position;
  if (active) {
    const float wanted = std::clamp(pointer - grabbed_at, minimum, std::max(minimum, maximum));
    edit.changed = wanted != position;
    position = wanted;
  }
  edit.finished = ImGui::IsItemDeactivated();
  const bool strong = active || ImGui::IsItemHovered();
  const float half = std::max(1.0f, std::floor(px(strong ? 2 : 1))) / 2;
  const ImVec2 middle{std::floor((min.x + max.x) / 2), std::floor((min.y + max.y) / 2)};
  ImGui::GetWindowDrawList()->AddRectFilled(upright ? ImVec2{middle.x - half, min.y} : ImVec2{min.x, middle.y - half},
                                            upright ? ImVec2{middle.x + half, max.y} : ImVec2{max.x, middle.y + half},
                                            colour_u32(strong ? p.text_quiet : p.line));
  controls().record(name, short_number(position));
  return edit;
}

}  // namespace ps::gui
