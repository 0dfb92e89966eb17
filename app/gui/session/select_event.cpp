#include "gui/session/select_event.h"

namespace ps::gui {
namespace {

void select(Session& session, Side side, int event, bool until_event) {
  session.navigate([&](Document& document) {
    event_of(document, side) = event;
    document.story.until_event = until_event;
  });
}

}  // namespace

void select_event(Session& session, Side side, int event) { select(session, side, event, false); }
void go_through_to(Session& session, Side side, int event) { select(session, side, event, true); }

}  // namespace ps::gui
