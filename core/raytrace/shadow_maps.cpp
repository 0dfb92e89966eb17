#include "raytrace/shadow_maps.h"

#include "raster/maps.h"

namespace ps {

template <class Real>
void add_shadow_maps(TraceInputs<Real>& inputs, const Scene& scene, Prepared& prepared, WorkerPriority priority,
                     Progress& progress) {
  if (!raster::uses_shadow_maps(inputs.settings, scene)) return;
  Settings as_traced = inputs.settings;
  as_traced.patches = Patches::as_made;  // rays meet the triangles of the scene file, whatever the rasterizer draws
  inputs.shadow_maps = raster::shadow_maps(scene, as_traced, prepared, priority, progress);
}

template void add_shadow_maps(TraceInputs<float>&, const Scene&, Prepared&, WorkerPriority, Progress&);
template void add_shadow_maps(TraceInputs<double>&, const Scene&, Prepared&, WorkerPriority, Progress&);

}  // namespace ps
