#pragma once
#include "gui/session/session.h"

namespace ps::gui {

/// Selects an event of a side's story, or none with -1. All of the story is drawn again.
void select_event(Session& session, Side side, int event);
/// Selects an event, and nothing after it is drawn: the story is gone through.
void go_through_to(Session& session, Side side, int event);

}  // namespace ps::gui
