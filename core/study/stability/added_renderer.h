#pragma once
#include <algorithm>
#include <string_view>

#include "options/renderer_kind.h"

namespace ps::stability {

/// The key of the hardware renderer, which comes with some programs only (core/README.md). For experiments that are
/// about it and for saying that a program lacks it; all else asks the renderer's row.
inline constexpr std::string_view hardware_renderer_key = "hardware";

/// The number of the hardware renderer. Programs without it do not have the experiments that ask.
inline Renderer hardware_renderer() {
  const auto all = renderer_kinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const RendererKind& kind) { return kind.key == hardware_renderer_key; });
  return static_cast<Renderer>(found - all.begin());
}

}  // namespace ps::stability
