#pragma once
#include <array>
#include <string_view>

#include "scene/scene.h"

namespace ps::test {

/// What a scene can be without, and a renderer must not count on.
enum class Bare { without_casters, without_lights, without_objects };
inline constexpr std::array all_bare{Bare::without_casters, Bare::without_lights, Bare::without_objects};

/// "without casters".
std::string_view bare_name(Bare what);

/// The scene without it. Casters go by making every surface transparent.
Scene bare_scene(Scene scene, Bare what);

}  // namespace ps::test
