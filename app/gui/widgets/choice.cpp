#include <fmt/format.h>
#include <imgui_internal.h>  // where a list has room

#include <algorithm>
#include <cmath>

#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/tab_row.h"

namespace ps::gui {
namespace {

std::string part_name(std::string_view name, std::string_view key) {
  return std::string(name) + "/" + std::string(key);
}

/// Why choice `i` cannot act now.
std::string idle_reason(const ControlStyle& style, std::size_t i) { return style.idle ? style.idle(i) : ""; }

/// A choice that cannot act is greyed, but can be taken: other settings may wake it.
ImVec4 choice_colour(const ControlStyle& style, std::size_t i) {
  return idle_reason(style, i).empty() ? text_colour(style) : palette().text_disabled;
}

float segment_width(const Choice& choice) { return text_width(choice.label) + 2 * ImGui::GetStyle().FramePadding.x; }

float segments_width(std::span<const Choice> choices) {
  float width = 0;
  for (const Choice& one : choices) width += segment_width(one);
  return width;
}

bool segments(std::string_view name, std::span<const Choice> choices, int& index, float width,
              const ControlStyle& style) {
  const Palette& p = palette();
  const float stretch = std::max(0.0f, width - segments_width(choices)) / static_cast<float>(choices.size());
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const ImVec2 end{start.x + width, start.y + ImGui::GetFrameHeight()};
  ImGui::GetWindowDrawList()->AddRectFilled(start, end, colour_u32(style.disabled.empty() ? p.field : p.panel),
                                            ImGui::GetStyle().FrameRounding);
  bool changed = false;
  ImGui::BeginGroup();
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 0);
    const std::string part = part_name(name, choices[i].key);
    const bool chosen = static_cast<std::size_t>(index) == i;
    const ButtonLook look{
        .fill = chosen ? p.selection : ImVec4{0, 0, 0, 0}, .text = choice_colour(style, i), .on = chosen};
    if (word_button(part, choices[i].label, segment_width(choices[i]) + stretch, look, style) && !chosen) {
      index = static_cast<int>(i);
      changed = true;
    }
    controls().record(part, chosen ? "on" : "off", style.disabled.empty());
    const ControlStyle own{.tooltip = style.tooltip.empty() ? choices[i].help : style.tooltip,
                           .disabled = style.disabled.empty() ? idle_reason(style, i) : style.disabled};
    style_tooltip(own);
  }
  ImGui::EndGroup();
  outline(start, end, p.line);
  return changed;
}

}  // namespace

bool drop_down(std::string_view name, std::span<const Choice> choices, int& index, float width,
               const ControlStyle& style, const FieldLook& look) {
  const Palette& p = palette();
  const ImGuiID list = ImGui::GetID(full_name(part_name(name, "##list")).c_str());
  const float height = std::max(look.height, ImGui::GetFrameHeight());
  const float arrow = px(16);
  const auto chosen = static_cast<std::size_t>(std::clamp<int>(index, 0, static_cast<int>(choices.size()) - 1));
  const ButtonLook field{
      .fill = p.field, .edge = p.line, .text = choice_colour(style, chosen), .height = height, .align = 0};
  bool wanted = false;
  {
    const FontScope font(look.face);
    std::string text(style.shown.empty() ? choices[chosen].label : style.shown);
    if (text.find('\n') == std::string::npos) text = whole_words(text, width - arrow - px(8));
    wanted = word_button(name, text, width, field, style);
  }
  if (wanted && !ImGui::IsPopupOpen(list, ImGuiPopupFlags_None)) {  // Enter closes an open one
    ImGui::OpenPopup(list);
    key_focus().go_to(full_name(name));  // while the list is open, the arrow keys belong to it
  }
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const float scale = 0.6f, size = ImGui::GetFontSize();
  ImGui::RenderArrow(ImGui::GetWindowDrawList(), {max.x - (arrow + size) / 2, (min.y + max.y - size * scale) / 2},
                     colour_u32(style.disabled.empty() ? p.text_quiet : p.text_disabled), ImGuiDir_Down, scale);
  controls().record(name, std::string(choices[chosen].key), style.disabled.empty());
  ControlStyle own = style;
  if (own.disabled.empty()) own.disabled = idle_reason(style, chosen);
  style_tooltip(own);

  bool changed = false;
  const int last = static_cast<int>(choices.size()) - 1;
  if (const int steps = key_focus().steps(); key_focus().is_at(full_name(name)) && style.disabled.empty()) {
    changed = steps != 0 && std::clamp(index + steps, 0, last) != index;
    index = std::clamp(index + steps, 0, last);
    key_focus().use_steps();
  }
  if (!ImGui::BeginComboPopup(list, {min, max}, ImGuiComboFlags_HeightLargest)) return changed;
  if (key_focus().is_at(full_name(name)) && !ImGui::IsWindowAppearing()) {
    const int lit = std::clamp(index + key_focus().lines(), 0, last);
    changed = changed || lit != index;
    index = lit;
    key_focus().use_lines();
    if (key_focus().pressed()) ImGui::CloseCurrentPopup();
  }
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const std::string label(choices[i].label);
    ImGui::PushStyleColor(ImGuiCol_Text, choice_colour({.idle = style.idle}, i));
    if (ImGui::Selectable(label.c_str(), i == chosen) && i != chosen) {
      index = static_cast<int>(i);
      changed = true;
    }
    ImGui::PopStyleColor();
    controls().record(part_name(name, choices[i].key), i == chosen ? "on" : "off");
    style_tooltip({.tooltip = choices[i].help, .disabled = idle_reason(style, i)});
  }
  ImGui::EndPopup();
  return changed;
}

bool choices_drop_down(std::span<const Choice> choices, float width) {
  return segments_width(choices) > width || choices.size() > 5;
}

bool choice(std::string_view name, std::span<const Choice> choices, int& index, const ControlStyle& style) {
  if (choices.empty()) return false;
  const float width = full_width(style);
  bool changed = false;
  if (!choices_drop_down(choices, width)) {
    changed = segments(name, choices, index,
                       style.width > 0 ? width : std::min(width, std::max(segments_width(choices), px(150))), style);
    const auto chosen = static_cast<std::size_t>(std::clamp<int>(index, 0, static_cast<int>(choices.size()) - 1));
    controls().record(name, std::string(choices[chosen].key), style.disabled.empty());
  } else {
    changed = drop_down(name, choices, index, width, style);
  }
  return changed;
}

bool tab_row(std::string_view name, std::span<const Choice> tabs, int& index) { return tab_row(name, tabs, {}, index); }

bool tab_row(std::string_view name, std::span<const Choice> tabs, std::span<const std::string_view> brief, int& index,
             float reserved) {
  bool changed = false;
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float whole = ImGui::GetContentRegionAvail().x, room = whole - reserved;
  bool shortened = false;
  const auto label = [&](std::size_t i) { return shortened ? brief[i] : tabs[i].label; };
  const auto row_width = [&](float between) {
    float sum = 0;
    for (std::size_t i = 0; i < tabs.size(); ++i) sum += text_width(label(i)) + between;
    return sum;
  };
  const float height = ImGui::GetFrameHeight() + px(4);
  // Tabs that do not fit one row are written smaller, then with shorter labels, and go on in the next row if need be:
  // half a word says nothing.
  const bool tight = row_width(px(22)) > room;
  const FontScope font(tight ? Face::small : Face::body);
  shortened = tight && brief.size() == tabs.size() && row_width(px(8)) > room;
  const float margin = shortened ? px(5) : tight ? px(8) : px(22);
  const bool wraps = tight && row_width(margin) > room;
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {std::min(px(8), margin / 2), ImGui::GetStyle().FramePadding.y});
  for (std::size_t i = 0; i < tabs.size(); ++i) {
    const float width = std::floor(std::min(text_width(label(i)) + margin, room));
    if (i > 0 && (!wraps || ImGui::GetItemRectMax().x + width <= start.x + room)) ImGui::SameLine(0, 0);
    const std::string part = part_name(name, tabs[i].key);
    const bool open = static_cast<std::size_t>(index) == i;
    const bool wanted_by_script =
        controls().revealing().starts_with(full_name(part) + "/") && !controls().revealing().empty();
    const ButtonLook look{.text = open ? palette().text : palette().text_quiet, .height = height, .on = open};
    if ((word_button(part, label(i), width, look, {}) || wanted_by_script) && !open) {
      index = static_cast<int>(i);
      changed = true;
    }
    controls().record(part, open ? "on" : "off");
    if (shortened && brief[i] != tabs[i].label)
      tooltip(fmt::format("{}: {}", tabs[i].label, tabs[i].help));
    else if (!tabs[i].help.empty())
      tooltip(tabs[i].help);
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  const float bottom = ImGui::GetItemRectMax().y - 0.5f;
  ImGui::GetWindowDrawList()->AddLine({start.x, bottom}, {start.x + whole, bottom}, colour_u32(palette().line));
  const auto chosen = static_cast<std::size_t>(std::clamp<int>(index, 0, static_cast<int>(tabs.size()) - 1));
  controls().record(name, std::string(tabs[chosen].key));
  return changed;
}

}  // namespace ps::gui
