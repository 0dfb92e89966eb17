#pragma once
#include <optional>
#include <string>

#include "gui/panels/story/pixel_panel.h"
#include "gui/session/session.h"

namespace ps::gui {

/// What of the panels belongs to the document, as it was when the two were last alike.
struct ScreenMirror {
  std::string right_tab = "story";
  int event = -1;
  std::optional<int> wanted;  ///< the event to select as soon as its story is there
};

/// Keeps the document's selected event and right tab the same as the inspector's, whichever of the two changed: what is
/// clicked goes into the permalink, and a permalink or an undo selects in the inspector.
void mirror_screen(Session& session, PixelPanelState& panel, ScreenMirror& mirror);

}  // namespace ps::gui
