#pragma once

#ifdef PIXELSCOPE_HARDWARE
#include "hardware/renderer.h"
#endif
#include "options/waking.h"
#include "render/renderer_table.h"

namespace ps {

/// Adds the renderers that core does not know and that this program was built with. First thing in main().
inline void add_renderers() {
#ifdef PIXELSCOPE_HARDWARE
  add_slow_start(add_renderer({hardware_renderer_kind(), hardware_renderer_row()}), hardware_driver_is_known);
#endif
}

}  // namespace ps
