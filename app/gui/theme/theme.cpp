#include "gui/theme/theme.h"

#include <algorithm>
#include <iterator>

namespace ps::gui {

void apply_colours(const Palette& p, ImVec4 (&c)[ImGuiCol_COUNT]) {
  const ImVec4 clear{0, 0, 0, 0};
  c[ImGuiCol_Text] = p.text;
  c[ImGuiCol_TextDisabled] = p.text_disabled;
  c[ImGuiCol_WindowBg] = p.panel;
  c[ImGuiCol_ChildBg] = clear;
  c[ImGuiCol_PopupBg] = p.field;
  c[ImGuiCol_Border] = p.line_strong;
  c[ImGuiCol_BorderShadow] = clear;
  c[ImGuiCol_FrameBg] = p.field;
  c[ImGuiCol_FrameBgHovered] = p.field_hover;
  c[ImGuiCol_FrameBgActive] = p.field_active;
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = p.panel;
  c[ImGuiCol_MenuBarBg] = p.window;
  c[ImGuiCol_ScrollbarBg] = clear;
  c[ImGuiCol_ScrollbarGrab] = p.line;
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = p.line_strong;
  c[ImGuiCol_CheckMark] = p.text;
  c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = p.line_strong;
  c[ImGuiCol_Button] = p.field;
  c[ImGuiCol_ButtonHovered] = p.field_hover;
  c[ImGuiCol_ButtonActive] = p.field_active;
  c[ImGuiCol_Header] = p.selection;
  c[ImGuiCol_HeaderHovered] = p.field_hover;
  c[ImGuiCol_HeaderActive] = p.field_active;
  c[ImGuiCol_Separator] = p.line;
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = p.line_strong;
  c[ImGuiCol_ResizeGrip] = c[ImGuiCol_ResizeGripHovered] = c[ImGuiCol_ResizeGripActive] = clear;
  c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = clear;
  c[ImGuiCol_TabHovered] = p.field_hover;
  c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = p.selection;
  c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotHistogram] = p.text_quiet;
  c[ImGuiCol_PlotLinesHovered] = c[ImGuiCol_PlotHistogramHovered] = p.text;
  c[ImGuiCol_TableHeaderBg] = p.panel;
  c[ImGuiCol_TableBorderStrong] = p.line_strong;
  c[ImGuiCol_TableBorderLight] = p.line;
  c[ImGuiCol_TableRowBg] = c[ImGuiCol_TableRowBgAlt] = clear;
  c[ImGuiCol_TextSelectedBg] = p.selection;
  c[ImGuiCol_DragDropTarget] = p.attention;
  c[ImGuiCol_NavHighlight] = p.text;
  c[ImGuiCol_NavWindowingHighlight] = p.text;
  c[ImGuiCol_NavWindowingDimBg] = c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.35f};
}

ImGuiStyle sizes_at_scale_1() {
  ImGuiStyle style;
  style.WindowPadding = {16, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {8, 4};
  style.CellPadding = {8, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 12;
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = 4;
  style.PopupRounding = 4;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.DisabledAlpha = 1;  // greyed text has a colour of its own, so that it stays legible
  return style;
}

namespace {

void apply_sizes(double scale) {
  ImGuiStyle style = sizes_at_scale_1();
  style.ScaleAllSizes(static_cast<float>(scale));
  std::copy(std::begin(ImGui::GetStyle().Colors), std::end(ImGui::GetStyle().Colors), std::begin(style.Colors));
  ImGui::GetStyle() = style;
}

}  // namespace

void Theme::set_brightness(Brightness brightness) {
  colours_stale_ = colours_stale_ || brightness != brightness_;
  brightness_ = brightness;
}

void Theme::set_scale(double scale) {
  scale = std::clamp(scale, min_scale, max_scale);
  fonts_stale_ = fonts_stale_ || scale != scale_;
  scale_ = scale;
}

bool Theme::prepare() {
  if (colours_stale_) {
    palette_ = make_palette(brightness_);
    apply_colours(palette_, ImGui::GetStyle().Colors);
    colours_stale_ = false;
  }
  if (!fonts_stale_) return false;
  apply_sizes(scale_);
  load_fonts();
  fonts_stale_ = false;
  return true;
}

}  // namespace ps::gui
