#pragma once
#include "gui/session/session.h"

namespace ps::gui {

/// All lessons by their titles; a click begins one.
void lesson_list(Session& session);

}  // namespace ps::gui
