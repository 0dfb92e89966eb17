#pragma once
#include <algorithm>

#include "options/renderer_kind.h"

namespace ps::stability {

/// The number of the hardware renderer. Only for experiments that are about it: programs without it do not have them.
inline Renderer hardware_renderer() {
  const auto all = renderer_kinds();
  const auto found =
      std::find_if(all.begin(), all.end(), [](const RendererKind& kind) { return kind.key == "hardware"; });
  return static_cast<Renderer>(found - all.begin());
}

}  // namespace ps::stability
