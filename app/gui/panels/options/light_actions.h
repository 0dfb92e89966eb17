#pragma once
#include "gui/input/actions.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The keys that move the selected light, which must outlive them, and the actions that put lights into the scene or
/// take them out.
void add_light_actions(Actions& actions, Session& session, int& selected);

}  // namespace ps::gui
