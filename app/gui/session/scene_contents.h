#pragma once
#include <string_view>

#include "gui/session/picked_object.h"

namespace ps::gui {

/// Things put into the scene or taken out of it. Each is one step in the history, and part of permalinks and saved
/// scenes. New things come before the scene on the line of sight of the picked pixel, or of the picture's centre.

/// "sphere" or "box", as scene/contents.h has them. It is then the picked object.
void add_object(Session& session, PickedObject& picked, std::string_view kind);
/// A copy to the right of the picked object, which is then the picked one.
void duplicate_object(Session& session, PickedObject& picked);
void remove_object(Session& session, PickedObject& picked);

/// "point" or "directional". `selected` is the light that keys move; the new one takes its place.
void add_light(Session& session, int& selected, std::string_view kind);
/// A copy of a light, a point light a little above it.
void duplicate_light(Session& session, int& selected, std::size_t light);
void remove_light(Session& session, std::size_t light);

}  // namespace ps::gui
