#include <algorithm>
#include <array>

#include "raytrace/recorded_rays.h"
#include "raytrace/renderer.h"
#include "raytrace/shadow_maps.h"
#include "record/field_inputs.h"
#include "record/field_recorder.h"

namespace ps {
namespace {

/// Boxes and tests are reported by the clear search alone; and which blocker is found first depends on the search.
RecordedSearch search_for(const FieldQuery& query) {
  constexpr std::array<std::string_view, 4> reported{"node", "sphere-test", "triangle-test", "solid-test"};
  const bool clear = std::find(reported.begin(), reported.end(), query.kind) != reported.end() ||
                     query.key == "blocker" ||
                     std::find(query.path.begin(), query.path.end(), RayKind::shadow) != query.path.end();
  return clear ? RecordedSearch::clear : RecordedSearch::fastest;
}

template <class Real>
void field_in(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress) {
  TraceInputs<Real> inputs = make_trace_inputs<Real>(asked.scene, asked.view, asked.settings, prepared);
  add_shadow_maps(inputs, asked.scene, prepared, asked.parallel.priority, progress);
  Image<PixelId> owners(asked.view.width, asked.view.height);
  trace_recorded(asked.scene, inputs, sampling_plan(asked.settings), asked.view, asked.region, search_for(asked.query),
                 prepared, asked.parallel, progress,
                 [&](int) { return FieldRecorder(asked.query, asked.space, values, owners); });
}

}  // namespace

void find_field_of_rays(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress) {
  switch (asked.settings.precision) {
  case Precision::float32:
    return field_in<float>(asked, values, prepared, progress);
  case Precision::float64:
    return field_in<double>(asked, values, prepared, progress);
  }
}

}  // namespace ps
