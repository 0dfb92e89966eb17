#include "raytrace/touched.h"

#include "frame/working_scene.h"
#include "raytrace/recorded_rays.h"

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

template <class Real>
Touched touched_in(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                   Progress& progress, WorkerPriority priority) {
  TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, view, settings, prepared);
  inputs.settings.shadow_any_hit = false;  // which one is found first depends on the processor's tree
  SamplingPlan plan = sampling_plan(settings);
  if (plan.mode == SamplingMode::adaptive) plan.mode = SamplingMode::many;
  const ParallelOptions parallel{settings.threads, priority};
  const Touched none = nothing_touched(scene);
  std::vector<Touched> by_worker(static_cast<std::size_t>(resolve_threads(parallel)), none);
  trace_recorded(scene, inputs, plan, view, {0, 0, view.width, view.height}, RecordedSearch::fastest, prepared,
                 parallel, progress,
                 [&](int worker) { return TouchRecorder(by_worker[static_cast<std::size_t>(worker)]); });
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
