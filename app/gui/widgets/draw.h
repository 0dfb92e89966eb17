#pragma once
#include <imgui.h>

#include <array>
#include <string>
#include <string_view>

#include "gui/widgets/widgets.h"

/// Shared by the files of this folder.
namespace ps::gui {

inline float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }
/// Text in a rectangle, vertically centred; `align` 0 left, 0.5 middle, 1 right; cut with an ellipsis if too long.
void draw_text(ImVec2 min, ImVec2 max, std::string_view text, const ImVec4& colour, float align);
/// Breaks text into lines of at most this width, at blanks alone: Dear ImGui's own wrapping also breaks numbers behind
/// their point. A longer word gets a line of its own and sticks out.
std::string in_lines(std::string_view text, float width);
/// value_text() broken into lines where the room ends.
void value_paragraph(std::string_view name, std::string_view text);
inline float text_height(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).y;
}
/// Text from its upper left corner, as it is.
inline void draw_lines(ImVec2 at, std::string_view text, const ImVec4& colour) {
  ImGui::GetWindowDrawList()->AddText(at, colour_u32(colour), text.data(), text.data() + text.size());
}
/// A paragraph in the quiet colour, for what explains.
void quiet_text(const std::string& text);
/// A field of that colour, red, green and blue from 0 to 255, as an item.
void swatch(const std::array<int, 3>& levels, ImVec2 size);
/// A bar in the colour of a picture.
void side_bar(ImDrawList& list, ImVec2 min, ImVec2 max, Side side);
/// "A" or "B" in the current font behind such a bar, as an item of one line.
void side_letter(Side side);
/// A bar that asks for attention, with the edge that its yellow needs on a light ground.
void attention_bar(ImDrawList& list, ImVec2 min, ImVec2 max);
/// An invisible button with the id `name`, focusable and dead when `disabled` is not empty.
bool hit_area(std::string_view name, ImVec2 size, const ControlStyle& style);
/// The style's tooltip with the reason for being greyed, for the last item.
void style_tooltip(const ControlStyle& style);
/// Background of a field or button by the state of the last item.
ImVec4 state_colour(const ImVec4& idle, const ControlStyle& style);
/// Outline of a field; stronger while hovered.
void outline(ImVec2 min, ImVec2 max, const ImVec4& colour);
/// The width that a control takes: its own, or the space that is left.
float full_width(const ControlStyle& style);
inline const ImVec4& text_colour(const ControlStyle& style) {
  return style.disabled.empty() ? palette().text : palette().text_disabled;
}
/// Whether choice() has no room for its words side by side in this width, and drops a list down instead.
bool choices_drop_down(std::span<const Choice> choices, float width);
/// A field that is higher than one line, for texts that are broken into lines already.
struct FieldLook {
  float height = 0;  ///< 0 = one line
  Face face = Face::body;
};
/// The room that drop_down() leaves for its text.
inline float drop_down_text_width(float width) { return width - px(24); }
/// A list that drops down from a field of this width. Answers whether `index` changed.
bool drop_down(std::string_view name, std::span<const Choice> choices, int& index, float width,
               const ControlStyle& style, const FieldLook& look = {});

}  // namespace ps::gui
