#pragma once
#include "gui/input/actions.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The keys that move the selected light, which must outlive them.
void add_light_actions(Actions& actions, Session& session, const int& selected);

}  // namespace ps::gui
