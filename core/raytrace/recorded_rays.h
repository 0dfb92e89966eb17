#pragma once
#include <optional>
#include <type_traits>

#include "frame/region.h"
#include "raytrace/clear/intersector-inl.h"
#include "raytrace/clear/tile_rays.h"
#include "raytrace/clear/tracer-inl.h"
#include "raytrace/fast/fast_intersector.h"

namespace ps {

/// How the rays of a recorded picture are searched: by the clear path, which reports boxes and tests, or by the SIMD
/// search where the picture's path may use it, which reports neither.
enum class RecordedSearch { clear, fastest };

/// Traces the pixels of a region by the clear path, tile by tile and in reading order, with recorders of one's own:
/// make_recorder(worker) gives one for a tile. Throws Cancelled.
template <class Real, class MakeRecorder>
void trace_recorded(const Scene& scene, const TraceInputs<Real>& inputs, const SamplingPlan& plan, const View& view,
                    const TileRect& region, RecordedSearch search, Prepared& prepared, const ParallelOptions& parallel,
                    Progress& progress, const MakeRecorder& make_recorder) {
  using Recorder = std::invoke_result_t<const MakeRecorder&, int>;
  std::optional<WideInputs> wide;
  if constexpr (std::is_same_v<Real, float>)
    if (search == RecordedSearch::fastest) wide = wide_inputs(scene, inputs, prepared);
  const auto trace_tile = [&](const Tracer<Real, Recorder>& tracer, const TileRect& tile) {
    const TileRays<Real, Recorder> rays(tracer, plan, tile);
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        tracer.recorder().at(x, y);
        rays.pixel(x, y);
      }
  };
  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, traced_tile_size);
  parallel_for(static_cast<int>(tiles.size()), parallel, progress, [&](int index, int worker) {
    const TileRect& tile = tiles[static_cast<std::size_t>(index)];
    if (is_empty(common_part(tile, region))) return;
    Recorder recorder = make_recorder(worker);
    if constexpr (std::is_same_v<Real, float>)
      if (wide) {
        CountingRecorder uncounted;
        const FastIntersector found(inputs, *wide, uncounted);
        return trace_tile(Tracer<Real, Recorder>(inputs, recorder, found), tile);
      }
    trace_tile(Tracer<Real, Recorder>(inputs, recorder), tile);
  });
}

}  // namespace ps
