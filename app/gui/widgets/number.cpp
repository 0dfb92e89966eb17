#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <cmath>
#include <utility>

#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/number_scale.h"

namespace ps::gui {
namespace {

/// The one number that is being dragged or typed into.
struct NumberGesture {
  ImGuiID id = 0;
  bool typing = false, typing_began = false, moved = false;
  double start_position = 0;
  float start_x = 0;
  std::string text = {};
  std::string first = {};  ///< the keys that began the typing, to be typed
};
NumberGesture gesture;

/// The control under the pointer when the wheel began to turn: a list that scrolls under a resting pointer must not
/// turn the numbers that pass by.
struct WheelGesture {
  ImGuiID id = 0;
  double last = -1;
};
WheelGesture wheel;
constexpr double wheel_pause = 0.35;  // seconds that part two gestures

bool wheel_is_ours(ImGuiID id, bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  const double now = ImGui::GetTime();
  const bool fresh = now - wheel.last > wheel_pause;
  if (hovered && (fresh || wheel.id == id)) {
    // Taken in the frame before the wheel turns, which keeps the panel from scrolling.
    take_wheel_for_item();
    if (io.MouseWheel != 0) {
      wheel = {id, now};
      return true;
    }
  }
  return false;
}

void note_other_wheel() {
  static int noted_frame = -1;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0 || noted_frame == ImGui::GetFrameCount()) return;
  noted_frame = ImGui::GetFrameCount();
  if (wheel_is_taken()) return;
  wheel = {0, ImGui::GetTime()};
}

Edit typed(std::string_view name, double& value, const NumberRange& range, float width) {
  Edit edit;
  const float height = ImGui::GetFrameHeight();
  const FontScope mono(Face::mono);
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(6), std::floor((height - ImGui::GetFontSize()) / 2)});
  if (gesture.typing_began) give_keyboard_to_next_item();
  // Until the field is active, keys come here in place of it.
  const bool is_active = ImGui::GetActiveID() == ImGui::GetID("##typed");
  if (const auto digit = key_focus().digit(); digit && !is_active) gesture.first += *digit;
  if (is_active)
    for (const char key : std::exchange(gesture.first, {}))
      ImGui::GetIO().InputQueueCharacters.push_back(static_cast<ImWchar>(key));
  forget_edits_before("##typed");
  const bool enter = ImGui::InputText("##typed", &gesture.text,
                                      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  key_focus().item(full_name(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), true);
  const bool left = !gesture.typing_began && !ImGui::IsItemActive();
  gesture.typing_began = false;
  controls().record(name, gesture.text);
  const bool cancelled = key_pressed(Key::escape);
  if (!enter && !left) return edit;
  gesture.typing = false;
  gesture.id = 0;
  const auto wanted = typed_value(gesture.text, range);
  if (cancelled || !wanted) return edit;
  edit.changed = edit.finished = *wanted != value;
  value = *wanted;
  return edit;
}

void draw_number(const ImVec2& min, const ImVec2& max, double value, const NumberRange& range,
                 const ControlStyle& style) {
  const Palette& p = palette();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool dead = !style.disabled.empty();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(min, max, colour_u32(state_colour(p.field, style)), rounding);
  outline(min, max, !dead && (ImGui::IsItemHovered() || ImGui::IsItemActive()) ? p.line_strong : p.line);
  const float left = min.x + px(5), right = max.x - px(5);
  const float x = left + (right - left) * static_cast<float>(slider_position(value, range));
  const float y = max.y - px(3.5);
  draw.AddLine({left, y}, {right, y}, colour_u32(p.line), px(2));
  const ImU32 ink = colour_u32(dead ? p.text_disabled : p.text_quiet);
  draw.AddLine({left, y}, {x, y}, ink, px(2));
  draw.AddCircleFilled({x, y}, px(2.5), ink, 12);
  float unit_width = 0;
  if (!range.unit.empty()) {
    unit_width = text_width(range.unit, Face::small) + px(5);
    draw_text({max.x - px(6) - unit_width, min.y}, {max.x - px(6), max.y - px(3)}, range.unit,
              dead ? p.text_disabled : p.text_quiet, 1, Face::small);
  }
  draw_text({min.x + px(6), min.y}, {max.x - px(6) - unit_width, max.y - px(3)},
            style.shown.empty() ? short_number(value) : std::string(style.shown), text_colour(style), 1, Face::mono);
}

}  // namespace

Edit number(std::string_view name, double& value, const NumberRange& range, const ControlStyle& style) {
  note_other_wheel();
  const float width = full_width(style);
  ImGui::PushID(full_name(name).c_str());
  const ImGuiID id = ImGui::GetID("##number");
  if (gesture.typing && gesture.id == id) {
    const Edit edit = typed(name, value, range, width);
    ImGui::PopID();
    return edit;
  }
  Edit edit;
  hit_area("##number", {width, ImGui::GetFrameHeight()}, style);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const ImGuiIO& io = ImGui::GetIO();
  const bool dead = !style.disabled.empty();
  const bool hovered = ImGui::IsItemHovered() && !dead;
  if (ImGui::IsItemActivated()) {
    gesture = {.id = id, .start_position = slider_position(value, range), .start_x = io.MousePos.x};
    if (io.KeyCtrl || ImGui::IsMouseDoubleClicked(0)) {
      gesture.typing = gesture.typing_began = true;
      gesture.text = full_number(value);
      ImGui::ClearActiveID();
    }
  }
  if (ImGui::IsItemActive() && gesture.id == id && !gesture.typing) {
    const float dx = io.MousePos.x - gesture.start_x;
    gesture.moved = gesture.moved || std::abs(dx) >= io.MouseDragThreshold / 2;
    if (gesture.moved) {
      const double fine = io.KeyShift ? 0.1 : 1;
      const double wanted = slider_value(gesture.start_position + fine * dx / std::max(1.0f, width - px(10)), range);
      edit.changed = wanted != value;
      value = wanted;
    }
  }
  if (ImGui::IsItemDeactivated() && gesture.id == id && !gesture.typing) {
    edit.finished = gesture.moved;
    gesture = {};
  }
  if (!dead && wheel_is_ours(ImGui::GetItemID(), hovered && !ImGui::IsItemActive())) {
    const int steps = io.MouseWheel > 0 ? std::max(1, static_cast<int>(io.MouseWheel))
                                        : std::min(-1, static_cast<int>(io.MouseWheel));
    const double wanted = stepped_value(value, steps, range);
    edit.changed = edit.finished = wanted != value;
    value = wanted;
  }
  if (key_focus().item(full_name(name), min, max, !dead)) {
    if (const int steps = key_focus().steps(); steps != 0) {
      const double wanted = stepped_value(value, steps, range);
      edit.changed = edit.finished = wanted != value;
      value = wanted;
      key_focus().use_steps();
    }
    if (key_focus().pressed() || key_focus().digit()) {
      gesture = {.id = id, .typing = true, .typing_began = true, .text = full_number(value)};
      if (const auto digit = key_focus().digit()) gesture.first = *digit;
    }
  }
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  draw_number(min, max, value, range, style);
  ImGui::PopID();
  controls().record(name, min, max, full_number(value), !dead);
  style_tooltip(style);
  return edit;
}

}  // namespace ps::gui
