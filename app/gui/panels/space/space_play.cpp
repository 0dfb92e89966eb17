// Going through a story's events one by one.
#include <imgui.h>

#include <algorithm>

#include "gui/panels/space/space_panel.h"

namespace ps::gui {
namespace {

void show_step(SpacePanelState& state, StoryCursor& cursor, std::size_t step) {
  state.play.up_to = state.model.steps[step];
  cursor.selected = state.play.up_to;
  cursor.reveal = true;
}

}  // namespace

void step_story(Session& session, SpacePanelState& state, PixelPanelState& pixel, int by) {
  const auto& steps = state.model.steps;
  if (steps.empty()) return;
  StoryCursor& cursor = pixel.cursors[index_of(inspected_side(session))];
  // From the selected event, wherever it was selected; without one from before the first.
  const int from = state.shown_story ? shown_event(state.model, *state.shown_story, cursor.selected) : -1;
  const auto after = std::upper_bound(steps.begin(), steps.end(), from) - steps.begin();
  const auto last = static_cast<std::ptrdiff_t>(steps.size()) - 1;
  const std::ptrdiff_t next = by > 0 ? after : std::lower_bound(steps.begin(), steps.end(), from) - steps.begin() - 1;
  show_step(state, cursor, static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, last)));
}

void play_story(Session& session, SpacePanelState& state, PixelPanelState& pixel) {
  state.play.running = !state.play.running;
  if (!state.play.running || state.model.steps.empty()) return;
  StoryCursor& cursor = pixel.cursors[index_of(inspected_side(session))];
  const bool at_end = cursor.selected < 0 || cursor.selected >= state.model.steps.back() || state.play.up_to < 0;
  if (at_end) show_step(state, cursor, 0);
  state.play.next_at = ImGui::GetTime() + 1 / state.play.per_second;
}

}  // namespace ps::gui
