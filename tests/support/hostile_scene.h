#pragma once
#include <optional>
#include <random>
#include <string>

#include "scene/scene.h"

namespace ps::test {

/// A built-in scene's file in which one to four numbers are replaced by extreme ones (5e-324, 1e12, -1 and the like),
/// and its text; nothing where the result is refused.
struct HostileScene {
  Scene scene;
  std::string text;
};
std::optional<HostileScene> hostile_scene(std::mt19937& random);

}  // namespace ps::test
