#include "render/renderer_table.h"

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "raster/renderer.h"
#include "raytrace/renderer.h"
#include "textbook/renderer.h"

namespace ps {
namespace {

std::vector<RendererRow>& rows() {
  static std::vector<RendererRow> all{ray_tracer_row(), rasterizer_row(), textbook_row()};
  return all;
}

}  // namespace

std::span<const RendererRow> renderer_table() { return rows(); }

const RendererRow& renderer_row(Renderer renderer) {
  const auto table = renderer_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const RendererRow& r) { return r.renderer == renderer; });
  PS_ASSERT(found != table.end(), "a renderer without a row");
  return *found;
}

std::optional<Renderer> driver_renderer() {
  const auto table = renderer_table();
  const auto found = std::find_if(table.begin(), table.end(), [](const RendererRow& r) { return r.by_driver; });
  return found == table.end() ? std::nullopt : std::optional(found->renderer);
}

Renderer add_renderer(const AddedRenderer& added) {
  RendererRow row = added.row;
  row.renderer = add_renderer_kind(added.kind);
  rows().push_back(row);
  return row.renderer;
}

}  // namespace ps
