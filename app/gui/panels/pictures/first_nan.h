#pragma once
#include <optional>

#include "gui/session/session.h"

namespace ps::gui {

/// The first pixel in reading order that has a component which is not a number, or infinite; nullopt if all are finite.
std::optional<Vec2i> first_not_finite(const Image<Vec3f>& colour);

/// Picks the first such pixel of the picked picture, or else of the other one, and says what it is, or that there is
/// none. A picture that is not complete is not searched.
void go_to_first_nan(Session& session);

}  // namespace ps::gui
