#include "render/renderer_table.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "raster/renderer.h"
#include "raytrace/renderer.h"
#include "textbook/renderer.h"

namespace ps {

std::span<const RendererRow> renderer_table() {
  static const std::array<RendererRow, 3> table{ray_tracer_row(), rasterizer_row(), textbook_row()};
  return table;
}

const RendererRow& renderer_row(Renderer renderer) {
  const auto table = renderer_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const RendererRow& r) { return r.renderer == renderer; });
  PS_ASSERT(found != table.end(), "a renderer without a row");
  return *found;
}

}  // namespace ps
