#include "gui/panels/space/story_actions.h"

namespace ps::gui {

void add_story_actions(Actions& actions, Session& session, SpacePanelState& state) {
  const auto there_are_steps = [&state] { return !state.model.steps.empty(); };
  actions.add({.name = "story-play",
               .label = "Play or pause the story",
               .group = "Story",
               .keys = "Space",
               .run = [&session, &state] { play_story(session, state); },
               .enabled = there_are_steps,
               .checked = [&state] { return state.play.running; }});
  const auto step = [&](const char* name, const char* label, const char* keys, int by) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Story",
                 .keys = keys,
                 .kind = ActionKind::repeat,
                 .run = [&session, &state, by] { step_story(session, state, by); },
                 .enabled = there_are_steps});
  };
  step("story-back", "Previous event", ",", -1);
  step("story-forward", "Next event", ".", 1);
}

}  // namespace ps::gui
