#pragma once
#include <cstddef>

#include "gui/session/gizmo.h"

namespace ps::gui {

/// Fills in where the gizmo of an object is and what it can do. False for objects that have none.
bool place_gizmo(const Scene& scene, std::size_t object, Gizmo& gizmo);

}  // namespace ps::gui
