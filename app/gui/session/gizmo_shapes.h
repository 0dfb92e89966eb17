#pragma once
#include <cstddef>

#include "gui/session/gizmo.h"

namespace ps::gui {

/// Where the centre of a model's bounding sphere lies in the world. Frames ask for it again and again, so that of a
/// mesh is kept as long as the mesh is there. For the window's thread alone.
Vec3d centre_of(const Scene& scene, const Instance& instance);

/// Fills in where the gizmo of an object is and what it can do. False for objects that have none.
bool place_gizmo(const Scene& scene, std::size_t object, Gizmo& gizmo);

}  // namespace ps::gui
