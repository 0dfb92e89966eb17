#include "raster/assembly/bins.h"

#include <algorithm>

#include "raster/setup/draw_stage.h"

namespace ps::raster {
namespace {

constexpr std::size_t primitives_per_part = 16384;
constexpr std::size_t most_parts = 16;

template <class Real>
TileRect touched(const RasterInputs<Real>& inputs, const ScreenTriangle<Real>& triangle) {
  return tested_box(inputs, triangle);
}
template <class Real>
TileRect touched(const RasterInputs<Real>&, const ScreenLine<Real>& line) {
  return line.box;
}

/// Calls visit(primitive) for the triangle or line that `ref` names.
template <class Real, class Visit>
auto with_primitive(const ScreenGeometry<Real>& geometry, const PrimitiveRef& ref, Visit&& visit) {
  const Batch<Real>& batch = geometry.batches[ref.batch];
  if (ref.is_line()) return visit(batch.lines[ref.index]);
  return visit(batch.triangles[ref.index]);
}

}  // namespace

template <class Real>
std::vector<PrimitiveRef> drawing_order(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry) {
  std::vector<PrimitiveRef> order;
  std::size_t total = 0;
  for (const Batch<Real>& batch : geometry.batches) total += batch.triangles.size() + batch.lines.size();
  order.reserve(total);
  for (std::size_t b = 0; b < geometry.batches.size(); ++b) {
    const Batch<Real>& batch = geometry.batches[b];
    const auto number = static_cast<std::uint32_t>(b);
    std::uint32_t line = 0;
    // The lines of a triangle come after all of its pieces.
    const auto add_lines_before = [&](std::uint32_t sequence) {
      for (; line < batch.lines.size() && batch.lines[line].sequence < sequence; ++line)
        order.push_back({number, line, PrimitiveShape::line});
    };
    for (std::size_t i = 0; i < batch.triangles.size(); ++i) {
      add_lines_before(batch.triangles[i].sequence);
      order.push_back({number, static_cast<std::uint32_t>(i)});
    }
    add_lines_before(~std::uint32_t{0});
  }
  if (!sorts_triangles(inputs.settings)) return order;
  const bool all = inputs.settings.visibility == Visibility::painter;
  const auto opaque = [&](const PrimitiveRef& ref) {
    return with_primitive(geometry, ref,
                          [&](const auto& p) { return !inputs.surfaces[p.surface].material.passes_light(); });
  };
  const auto sorted = all ? order.begin() : std::stable_partition(order.begin(), order.end(), opaque);
  struct Place {
    Real depth;
    std::uint32_t sequence;
  };
  const auto place = [&](const PrimitiveRef& ref) {
    return with_primitive(geometry, ref, [](const auto& p) { return Place{p.sort_depth, p.sequence}; });
  };
  std::stable_sort(sorted, order.end(), [&](const PrimitiveRef& a, const PrimitiveRef& b) {
    const Place first = place(a);
    const Place second = place(b);
    if (first.depth != second.depth) return first.depth > second.depth;
    return first.sequence > second.sequence;
  });
  return order;
}

template <class Real>
Bins bin_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                    std::span<const PrimitiveRef> order, int tile_size, const ParallelOptions& parallel,
                    Progress& progress) {
  const auto tiles_across = [tile_size](int pixels) { return (pixels + tile_size - 1) / tile_size; };
  const auto columns = static_cast<std::size_t>(tiles_across(inputs.viewport.columns));
  const auto rows = static_cast<std::size_t>(tiles_across(inputs.viewport.rows));
  Bins bins;
  bins.tiles = columns * rows;
  bins.parts = std::clamp<std::size_t>(order.size() / primitives_per_part, 1, most_parts);
  bins.lists.resize(bins.parts * bins.tiles);
  parallel_for(static_cast<int>(bins.parts), parallel, progress, [&](int index, int) {
    const auto part = static_cast<std::size_t>(index);
    const std::size_t last = order.size() * (part + 1) / bins.parts;
    for (std::size_t i = order.size() * part / bins.parts; i < last; ++i) {
      const TileRect box = with_primitive(geometry, order[i], [&](const auto& p) { return touched(inputs, p); });
      for (int row = box.y0 / tile_size; row <= (box.y1 - 1) / tile_size; ++row)
        for (int column = box.x0 / tile_size; column <= (box.x1 - 1) / tile_size; ++column)
          bins.lists[part * bins.tiles + static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)]
              .push_back(order[i]);
    }
  });
  return bins;
}

template <class Real>
Bins bin_primitives(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry, int tile_size,
                    const ParallelOptions& parallel, Progress& progress) {
  return bin_primitives<Real>(inputs, geometry, drawing_order(inputs, geometry), tile_size, parallel, progress);
}

#define PS_INSTANTIATE(Real)                                                                                           \
  template std::vector<PrimitiveRef> drawing_order(const RasterInputs<Real>&, const ScreenGeometry<Real>&);            \
  template Bins bin_primitives(const RasterInputs<Real>&, const ScreenGeometry<Real>&, std::span<const PrimitiveRef>,  \
                               int, const ParallelOptions&, Progress&);                                                \
  template Bins bin_primitives(const RasterInputs<Real>&, const ScreenGeometry<Real>&, int, const ParallelOptions&,    \
                               Progress&);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE

}  // namespace ps::raster
