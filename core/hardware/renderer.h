#pragma once
#include "options/renderer_kind.h"
#include "record/renderer_row.h"

namespace ps {

/// The renderer that draws with OpenGL 3.3, on a graphics processor or with Mesa's llvmpipe (CGPP 15.7): what the
/// option table shows of it, and its row. For add_renderer() in a program's main().
RendererKind hardware_renderer_kind();
RendererRow hardware_renderer_row();

/// Whether the driver was started, so that RendererKind::inactive answers at once. For add_slow_start().
bool hardware_driver_is_known();

}  // namespace ps
