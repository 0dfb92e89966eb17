#pragma once
#include "gui/session/session.h"

namespace ps::gui {

/// Stage times and counters of A and B side by side, with their ratio.
void timings_panel(Session& session);

}  // namespace ps::gui
