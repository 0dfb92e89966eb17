#pragma once
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>

#include "gui/widgets/widgets.h"

/// Shared by the files of this folder.
namespace ps::gui {

/// In the face, or in the present one.
float text_width(std::string_view text, std::optional<Face> face = {});
/// Text in a rectangle, vertically centred; `align` 0 left, 0.5 middle, 1 right; cut with an ellipsis if too long.
void draw_text(ImVec2 min, ImVec2 max, std::string_view text, const ImVec4& colour, float align,
               std::optional<Face> face = {});
/// Breaks text into lines of at most this width, at blanks alone: Dear ImGui's own wrapping also breaks numbers behind
/// their point. A longer word is broken behind its signs /, _ and -, or else sticks out.
std::string in_lines(std::string_view text, float width);
inline float text_height(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).y;
}
/// Text from its upper left corner, as it is.
inline void draw_lines(ImVec2 at, std::string_view text, const ImVec4& colour) {
  ImGui::GetWindowDrawList()->AddText(at, colour_u32(colour), text.data(), text.data() + text.size());
}
/// A field of that colour with an edge.
void draw_swatch(ImDrawList& list, ImVec2 corner, ImVec2 size, ImU32 colour);
/// The same as an item, red, green and blue from 0 to 255; without a size a square as high as a line.
void swatch(const std::array<int, 3>& levels, ImVec2 size = {0, 0});
/// The sign of what is done, at the left end of a row of this height.
void draw_tick(ImVec2 row, float height);
/// A bar in the colour of a picture.
void side_bar(ImDrawList& list, ImVec2 min, ImVec2 max, Side side);
/// "A" or "B" in the current font behind such a bar, as an item of one line.
void side_letter(Side side);
/// A bar that asks for attention, with the edge that its yellow needs on a light ground.
void attention_bar(ImDrawList& list, ImVec2 min, ImVec2 max);
/// Lets `make` make one of Dear ImGui's items with the id `name`: it is dead where the style says so, and can have the
/// keyboard. Answers what `make` does, or whether it has the keyboard and was pressed.
bool item(std::string_view name, const ControlStyle& style, const std::function<bool()>& make);
struct ButtonLook {
  ImVec4 fill{0, 0, 0, 0}, edge{0, 0, 0, 0};
  ImVec4 text = palette().text;
  float height = 0;    ///< 0 = that of a line with controls
  bool on = false;     ///< a bar below its words: never by colour alone
  float align = 0.5f;  ///< 0 left, 0.5 middle
};
/// Dear ImGui's button with words in it. The caller records it.
bool word_button(std::string_view name, std::string_view label, float width, const ButtonLook& look,
                 const ControlStyle& style);
/// An invisible item() of this size.
bool hit_area(std::string_view name, ImVec2 size, const ControlStyle& style);
/// The style's tooltip with the reason for being greyed, for the last item.
void style_tooltip(const ControlStyle& style);
/// Background of a field or button by the state of the last item.
ImVec4 state_colour(const ImVec4& idle, const ControlStyle& style);
inline float line_thickness() { return std::max(1.0f, std::floor(px(1))); }
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
