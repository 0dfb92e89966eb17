#pragma once
#include "gui/session/picked_object.h"

namespace ps::gui {

/// State of the panel.
struct ObjectPanelState {
  bool open = false;
  int come = 0;  ///< frames in which it is still to be scrolled to: what has just opened has its height only then
};

/// Place, size and material of the picked object, to be changed by numbers. `gizmo` is whether the pictures show its
/// gizmo.
void object_panel(Session& session, ObjectPanelState& state, PickedObject& picked, bool& gizmo);

}  // namespace ps::gui
