#pragma once
#include <string_view>

#include "scene/scene.h"

namespace ps {

/// Things put into a scene or taken out of it while it is looked at. Paths and their values:
///   object.add     sphere, box or cylinder: a white one of about one unit at the origin, behind all other objects
///   object.copy    N, or N + (x, y, z): object N once more, moved by that much, behind all other objects
///   object.remove  N: those behind it move up by one
///   light.add      ambient, point or directional: behind all other lights
///   light.copy     N, or N + (x, y, z): of a point light the position is moved
///   light.remove   N: those behind it move up by one
bool changes_contents(std::string_view path);

/// Makes one such change. Only the parts of the scene that hold what changes get a new revision. Throws InputError for
/// a value that does not fit, and beyond the limits of scene files; the scene is then unchanged.
void change_contents(Scene& scene, std::string_view path, std::string_view value);

}  // namespace ps
