#include "raytrace/touched.h"

#include <optional>
#include <type_traits>

#include "frame/working_scene.h"
#include "raytrace/clear/intersector-inl.h"
#include "raytrace/clear/tile_rays.h"
#include "raytrace/clear/tracer-inl.h"
#include "raytrace/fast/fast_intersector.h"

namespace ps {
namespace {

Touched nothing_touched(const Scene& scene) {
  Touched touched;
  for (const Object& object : scene.geometry->objects) {
    Touched::Object& one = touched.objects.emplace_back();
    if (const auto* instance = std::get_if<Instance>(&object.shape))
      one.triangles.resize(scene.geometry->meshes[instance->mesh]->triangles.size());
  }
  touched.lights.resize(scene.lights->size());
  return touched;
}

/// Traces the pixels of one tile.
template <class Real>
void touch_tile(const Tracer<Real, TouchRecorder>& tracer, const SamplingPlan& plan, const TileRect& tile) {
  const TileRays<Real, TouchRecorder> rays(tracer, plan, tile);
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x) {
      tracer.recorder().next_pixel();
      rays.pixel(x, y);
    }
}

template <class Real>
Touched touched_in(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                   Progress& progress, WorkerPriority priority) {
  TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, view, settings, prepared);
  inputs.settings.shadow_any_hit = false;  // which one is found first depends on the processor's tree
  std::optional<WideInputs> wide;          // the SIMD search, where this picture's path may use it
  if constexpr (std::is_same_v<Real, float>) wide = wide_inputs(scene, inputs, prepared);
  SamplingPlan plan = sampling_plan(settings);
  if (plan.mode == SamplingMode::adaptive) plan.mode = SamplingMode::many;
  const ParallelOptions parallel{settings.threads, priority};
  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, traced_tile_size);
  const Touched none = nothing_touched(scene);
  std::vector<Touched> by_worker(static_cast<std::size_t>(resolve_threads(parallel)), none);
  parallel_for(static_cast<int>(tiles.size()), parallel, progress, [&](int index, int worker) {
    const TileRect& tile = tiles[static_cast<std::size_t>(index)];
    TouchRecorder recorder(by_worker[static_cast<std::size_t>(worker)]);
    if constexpr (std::is_same_v<Real, float>)
      if (wide) {
        CountingRecorder uncounted;
        const FastIntersector search(inputs, *wide, uncounted);
        return touch_tile(Tracer<Real, TouchRecorder>(inputs, recorder, search), plan, tile);
      }
    touch_tile(Tracer<Real, TouchRecorder>(inputs, recorder), plan, tile);
  });
  Touched all = none;
  for (const Touched& part : by_worker) all.add(part);
  return all;
}

}  // namespace

Touched touched_by_rays(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                        Progress& progress, WorkerPriority priority) {
  const WorkingScene working(scene, view, settings, prepared);
  switch (settings.precision) {
  case Precision::float32:
    return touched_in<float>(working.scene(), working.view(), working.settings(), prepared, progress, priority);
  case Precision::float64:
    return touched_in<double>(working.scene(), working.view(), working.settings(), prepared, progress, priority);
  }
  return {};
}

}  // namespace ps
