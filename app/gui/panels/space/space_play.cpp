// Going through a story's events one by one.
#include <imgui.h>

#include <algorithm>

#include "gui/panels/space/space_panel.h"
#include "gui/session/select_event.h"
#include "gui/widgets/redraw.h"

namespace ps::gui {
namespace {

/// The selected event, or the one that represents it in the model.
int selected_step(const Session& session, const SpacePanelState& state) {
  if (!state.shown_story) return -1;
  return shown_event(state.model, *state.shown_story, session.selected_event(inspected_side(session)));
}

void show_step(Session& session, SpacePanelState& state, std::size_t step) {
  state.play.played = state.model.steps[step];
  go_through_to(session, inspected_side(session), state.play.played);
}

}  // namespace

int drawn_until(const Session& session, const SpacePanelState& state) {
  return session.document().story.until_event ? selected_step(session, state) : -1;
}

void step_story(Session& session, SpacePanelState& state, int by) {
  const auto& steps = state.model.steps;
  if (steps.empty()) return;
  // From the selected event, wherever it was selected; without one from before the first.
  const int from = selected_step(session, state);
  const auto after = std::upper_bound(steps.begin(), steps.end(), from) - steps.begin();
  const auto last = static_cast<std::ptrdiff_t>(steps.size()) - 1;
  const std::ptrdiff_t next = by > 0 ? after : std::lower_bound(steps.begin(), steps.end(), from) - steps.begin() - 1;
  show_step(session, state, static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, last)));
}

void play_story(Session& session, SpacePanelState& state) {
  state.play.running = !state.play.running;
  if (!state.play.running || state.model.steps.empty()) return;
  const int selected = session.selected_event(inspected_side(session));
  const bool at_end = selected < 0 || selected >= state.model.steps.back() || !session.document().story.until_event;
  if (at_end)
    show_step(session, state, 0);
  else
    state.play.played = selected;
  state.play.next_at = ImGui::GetTime() + 1 / state.play.per_second;
}

void advance_play(Session& session, SpacePanelState& state) {
  StoryPlay& play = state.play;
  if (!play.running) return;
  const bool elsewhere = session.selected_event(inspected_side(session)) != play.played;
  if (state.model.steps.empty() || elsewhere || !session.document().story.until_event) {
    play.running = false;
    return;
  }
  const double now = ImGui::GetTime();
  if (now >= play.next_at) {
    step_story(session, state, 1);
    play.next_at = now + 1 / play.per_second;
    if (play.played >= state.model.steps.back()) play.running = false;
  }
  if (play.running) redraw_after(std::max(0.0, play.next_at - now));
}

void SpacePanel::add_actions(Actions& actions) {
  ActionGroup story(actions, "Story", [this] { return !state_.model.steps.empty(); });
  story.add_toggle(
      "story-play", "Play or pause the story", "Space", [this] { play_story(session_, state_); },
      [this] { return state_.play.running; });
  story.add_repeated("story-back", "Previous event", ",", [this] { step_story(session_, state_, -1); });
  story.add_repeated("story-forward", "Next event", ".", [this] { step_story(session_, state_, 1); });
}

}  // namespace ps::gui
