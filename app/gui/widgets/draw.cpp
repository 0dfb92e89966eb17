#include "gui/widgets/draw.h"

#include "gui/widgets/key_focus.h"

#include <imgui_internal.h>

#include <algorithm>

#include "gui/base/fit.h"

namespace ps::gui {
namespace {

constexpr float least_height = 0.8f;  // of a line: the rest is free above and below its letters

}  // namespace

void draw_text(ImVec2 min, ImVec2 max, std::string_view text, const ImVec4& colour, float align) {
  if (text.empty()) return;
  const char* begin = text.data();
  const char* end = begin + text.size();
  const ImVec2 size = ImGui::CalcTextSize(begin, end);
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const float room = max.x - min.x;
  const float y = std::floor((min.y + max.y - size.y) / 2);
  const float x = std::floor(min.x + std::max(0.0f, room - size.x) * align);
  if (size.x > room + 1 || size.y * least_height > max.y - min.y + 1) fit_watch().shortened(min, max, text);
  if (size.x > room + 1)
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), {x, y}, {max.x, max.y}, max.x, max.x, begin, end, &size);
  else
    ImGui::GetWindowDrawList()->AddText({x, y}, colour_u32(colour), begin, end);
  ImGui::PopStyleColor();
}

std::string in_lines(std::string_view text, float width) {
  std::string lines;
  std::size_t line = 0;  // where the last one begins
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::size_t before = lines.size();
    lines += text.substr(at, end - at);
    // The line was broken too late if this word does not fit: then its blank becomes the break.
    if (before > line && text_width(std::string_view(lines).substr(line)) > width) {
      lines[before - 1] = '\n';
      line = before;
    }
    at = end + 1;
    if (end == text.size()) break;
    lines += text[end];
    if (text[end] == '\n') line = lines.size();
  }
  return lines;
}

void value_paragraph(std::string_view name, std::string_view text) {
  const std::string lines = in_lines(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(lines.data(), lines.data() + lines.size());
  controls().record(name, std::string(text));
}

void quiet_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

void swatch(const std::array<int, 3>& levels, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, IM_COL32(levels[0], levels[1], levels[2], 255), px(3));
  list.AddRect(at, {at.x + size.x, at.y + size.y}, colour_u32(palette().line_strong), px(3));
  ImGui::Dummy(size);
}

void side_bar(ImDrawList& list, ImVec2 min, ImVec2 max, Side side) {
  list.AddRectFilled(min, max, colour_u32(side == Side::a ? palette().a : palette().b));
}

void side_letter(Side side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), bar = px(4), gap = px(4);
  const std::string_view letter = side == Side::a ? "A" : "B";
  // In a line with controls, text keeps their base line.
  const float y = at.y + ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
  side_bar(*ImGui::GetWindowDrawList(), {at.x, y + px(1)}, {at.x + bar, y + line - px(1)}, side);
  ImGui::SetCursorScreenPos({at.x + bar + gap, at.y});
  ImGui::TextUnformatted(letter.data(), letter.data() + letter.size());
}

void attention_bar(ImDrawList& list, ImVec2 min, ImVec2 max) {
  list.AddRectFilled(min, max, colour_u32(palette().attention));
  list.AddRect(min, max, colour_u32(palette().text_quiet));
}

bool hit_area(std::string_view name, ImVec2 size, const ControlStyle& style) {
  const DisabledScope disabled(!style.disabled.empty());
  ImGui::PushID(full_name(name).c_str());
  const bool clicked = ImGui::InvisibleButton("##hit", {std::max(1.0f, size.x), std::max(1.0f, size.y)});
  ImGui::PopID();
  if (name.starts_with("##")) return clicked;  // a part of a control that asks for the keyboard itself
  const bool has_keys =
      key_focus().item(full_name(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), style.disabled.empty());
  return clicked || (has_keys && key_focus().pressed());
}

void style_tooltip(const ControlStyle& style) {
  if (style.tooltip.empty() && style.disabled.empty()) return;
  if (!begin_tooltip()) return;
  if (!style.tooltip.empty()) ImGui::TextUnformatted(style.tooltip.data(), style.tooltip.data() + style.tooltip.size());
  if (!style.disabled.empty())
    ImGui::TextColored(palette().text_quiet, "Not now: %.*s", static_cast<int>(style.disabled.size()),
                       style.disabled.data());
  end_tooltip();
}

ImVec4 state_colour(const ImVec4& idle, const ControlStyle& style) {
  if (!style.disabled.empty()) return palette().panel;
  if (ImGui::IsItemActive()) return palette().field_active;
  if (ImGui::IsItemHovered()) return palette().field_hover;
  return style.quiet ? palette().panel : idle;
}

void outline(ImVec2 min, ImVec2 max, const ImVec4& colour) {
  ImGui::GetWindowDrawList()->AddRect({min.x + 0.5f, min.y + 0.5f}, {max.x - 0.5f, max.y - 0.5f}, colour_u32(colour),
                                      ImGui::GetStyle().FrameRounding, 0, std::max(1.0f, std::floor(px(1))));
}

float full_width(const ControlStyle& style) {
  return std::floor(style.width > 0 ? style.width : std::max(px(40), ImGui::GetContentRegionAvail().x));
}

}  // namespace ps::gui
