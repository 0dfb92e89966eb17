#pragma once

#ifdef PIXELSCOPE_HARDWARE
#include "hardware/renderer.h"
#endif
#include "render/renderer_table.h"

namespace ps {

/// Adds the renderers that core does not know and that this program was built with. First thing in main().
inline void add_renderers() {
#ifdef PIXELSCOPE_HARDWARE
  add_renderer({hardware_renderer_kind(), hardware_renderer_row()});
#endif
}

}  // namespace ps
