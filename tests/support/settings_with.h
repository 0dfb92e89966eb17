#pragma once
#include <initializer_list>
#include <string_view>

#include "options/option.h"
#include "options/scene_settings.h"

/// Settings for tests, in one expression.

namespace ps {

/// Those for the scene, drawn by this renderer.
inline Settings settings_for(const Scene& scene, Renderer renderer) {
  Settings settings = settings_for(scene);
  settings.renderer = renderer;
  return settings;
}

/// `settings` with these assignments, one after the other: "renderer=rasterizer".
template <class Assignments>
Settings settings_with(Settings settings, const Assignments& assignments) {
  for (const std::string_view assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}
inline Settings settings_with(Settings settings, std::initializer_list<std::string_view> assignments) {
  return settings_with<std::initializer_list<std::string_view>>(settings, assignments);
}

}  // namespace ps
