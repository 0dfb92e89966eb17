#pragma once
#include "scene/scene.h"

namespace ps::test {

/// What a scene can be without, and a renderer must not count on.
enum class Bare { without_casters, without_lights, without_objects };

/// The scene without it. Casters go by making every surface transparent.
Scene bare_scene(Scene scene, Bare what);

}  // namespace ps::test
