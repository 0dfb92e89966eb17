#include "raster/assembly/screen_geometry.h"

#include "raster/assembly/vertex_stage.h"

namespace ps::raster {

template <class Real>
ScreenGeometry<Real> make_geometry(const RasterInputs<Real>& inputs, std::optional<Vec2i> inspected,
                                   const ParallelOptions& parallel, Progress& progress) {
  ScreenGeometry<Real> geometry;
  const std::vector<bool> culled = cull_objects(inputs);
  for (std::size_t i = 0; i < culled.size(); ++i)
    if (culled[i]) ++geometry.counters[Counter::objects_culled];
  geometry.vertices =
      run_vertex_stage(inputs, culled, inspected ? VertexUse::pixel : VertexUse::picture, parallel, progress);
  geometry.runs = make_runs(inputs, culled);
  geometry.batches.resize(geometry.runs.size());
  parallel_for(static_cast<int>(geometry.runs.size()), parallel, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    const TriangleRun& run = geometry.runs[i];
    geometry.batches[i] = assemble(inputs, geometry.vertices[run.object], run, inspected);
  });
  for (const auto& batch : geometry.batches) geometry.counters += batch.counters;
  return geometry;
}

template ScreenGeometry<float> make_geometry(const RasterInputs<float>&, std::optional<Vec2i>, const ParallelOptions&,
                                             Progress&);
template ScreenGeometry<double> make_geometry(const RasterInputs<double>&, std::optional<Vec2i>, const ParallelOptions&,
                                              Progress&);

}  // namespace ps::raster
