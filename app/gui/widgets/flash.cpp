#include "gui/widgets/flash.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gui/base/record.h"
#include "gui/theme/theme.h"
#include "gui/widgets/redraw.h"

namespace ps::gui {
namespace {

constexpr double shown_for = 1.8, waited_for = 1.5, pulses = 2;  // seconds, seconds, times

struct Flashing {
  std::vector<std::string> names;
  double asked = 0, seen = -1;  ///< ImGui's time; seen: the first of them was drawn
};
Flashing flashing;

void forget() {
  if (!flashing.names.empty() && controls().reveals(flashing.names.front())) controls().stop_revealing();
  flashing = {};
}

}  // namespace

void flash(std::vector<std::string> names) {
  forget();
  if (names.empty()) return;
  flashing = {std::move(names), ImGui::GetTime(), -1};
  controls().reveal(flashing.names.front());
  redraw_after(0);
}

bool flashes(std::string_view name) {
  return std::find(flashing.names.begin(), flashing.names.end(), name) != flashing.names.end();
}

void draw_flash() {
  if (flashing.names.empty()) return;
  const double now = ImGui::GetTime();
  if (now - (flashing.seen < 0 ? flashing.asked + waited_for - shown_for : flashing.seen) > shown_for) return forget();
  redraw_after(0.03);
  const double phase = flashing.seen < 0 ? 0 : (now - flashing.seen) / shown_for;
  const double strength = std::abs(std::cos(phase * pulses * std::numbers::pi)) * (1 - 0.5 * phase);
  for (const std::string& name : flashing.names) {
    const ControlRecord* control = controls().find(name);
    if (!control || !controls().visible(*control)) continue;
    if (flashing.seen < 0) {
      flashing.seen = now;
      controls().stop_revealing();
    }
    const ImVec2 min{control->min.x - px(2), control->min.y - px(2)},
        max{control->max.x + px(2), control->max.y + px(2)};
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    // A ring alone: yellow over the control would take its text below the contrast that it needs.
    const float grown = px(3) * static_cast<float>(strength);
    const ImVec2 low{min.x - grown, min.y - grown}, high{max.x + grown, max.y + grown};
    draw.AddRect(low, high, colour_u32(palette().text), px(5), 0, px(6));
    draw.AddRect(low, high, colour_u32(palette().attention), px(5), 0, px(3));
  }
}

}  // namespace ps::gui
