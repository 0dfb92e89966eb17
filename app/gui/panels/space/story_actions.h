#pragma once
#include "gui/input/actions.h"
#include "gui/panels/space/space_panel.h"

namespace ps::gui {

/// The keys that go through the story's events.
void add_story_actions(Actions& actions, Session& session, SpacePanelState& state);

}  // namespace ps::gui
