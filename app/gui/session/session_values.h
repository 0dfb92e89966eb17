#pragma once
#include "gui/base/values.h"
#include "gui/session/session.h"

namespace ps::gui {

/// What scripts may ask of the session: the document, what was made of it, messages. The session must outlive the
/// offers.
void offer_session_values(Values& out, Session& session);

}  // namespace ps::gui
