#pragma once
#include <span>

#include "record/renderer_row.h"

namespace ps {

/// All renderers, in the order of the option `renderer`.
std::span<const RendererRow> renderer_table();

/// The row of one of them.
const RendererRow& renderer_row(Renderer renderer);

}  // namespace ps
