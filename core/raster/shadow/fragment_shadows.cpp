#include "raster/shadow/fragment_shadows.h"

namespace ps::raster {

template <class Real>
void add_maps(Pass<Real>& pass, const Scene& scene, const View& view, const TileRect& rect, StencilNotes notes,
              Prepared& prepared, const ParallelOptions& parallel, Progress& progress) {
  if (uses_shadow_maps(pass.settings, scene))
    pass.shadow_maps = shadow_maps(scene, pass.settings, prepared, parallel.priority, progress);
  else if (uses_stencil(pass.settings, scene))
    pass.stencil = std::make_shared<const Stencil>(
        make_stencil(scene, view, pass.settings, rect, notes, prepared, parallel, progress));
  if (uses_environment(pass.settings, scene))
    pass.environment = environment_maps(scene, pass.settings, prepared, parallel.priority, progress);
}

template void add_maps(Pass<float>&, const Scene&, const View&, const TileRect&, StencilNotes, Prepared&,
                       const ParallelOptions&, Progress&);
template void add_maps(Pass<double>&, const Scene&, const View&, const TileRect&, StencilNotes, Prepared&,
                       const ParallelOptions&, Progress&);

}  // namespace ps::raster
