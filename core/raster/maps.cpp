#include "raster/maps.h"

#include <algorithm>

#include "raster/environment/draw_environment.h"
#include "raster/renderer.h"
#include "raster/shadow/draw_maps.h"
#include "raster/shadow/map_picture.h"

namespace ps::raster {

std::shared_ptr<const ShadowMaps> shadow_maps(const Scene& scene, const Settings& settings, Prepared& prepared,
                                              WorkerPriority priority, Progress& progress) {
  return prepared.get<ShadowMaps>(shadow_maps_key("shadow-maps", scene, settings), [&] {
    return draw_shadow_maps(scene, settings, [&](const Scene& dark, const View& view, const Settings& plain) {
      Prepared own;  // six views would push the picture's own products out of the shared one
      RenderRequest request;
      request.channels = Channel::depth;
      request.priority = priority;
      return render_rasterized(dark, view, plain, request, own, progress).depth;
    });
  });
}

std::shared_ptr<const EnvironmentMaps> environment_maps(const Scene& scene, const Settings& settings,
                                                        Prepared& prepared, WorkerPriority priority,
                                                        Progress& progress) {
  Settings own_settings = settings;
  own_settings.renderer = Renderer::rasterizer;
  RenderRequest request;
  request.priority = priority;
  Prepared own;  // the objects shown are a scene of their own; its products would push out the picture's
  return draw_environment_maps(scene, own_settings, prepared, 1,
                               [&](const Scene& shown, const View& view, const Settings& plain) {
                                 return render_rasterized(shown, view, plain, request, own, progress).colour;
                               });
}

template <class Real>
void add_maps(RasterInputs<Real>& inputs, const Scene& scene, const View& view, const TileRect& rect,
              StencilNotes notes, Prepared& prepared, const ParallelOptions& parallel, Progress& progress) {
  if (uses_shadow_maps(inputs.settings, scene))
    inputs.shadow_maps = shadow_maps(scene, inputs.settings, prepared, parallel.priority, progress);
  else if (uses_stencil(inputs.settings, scene))
    inputs.stencil = std::make_shared<const Stencil>(
        make_stencil(scene, view, inputs.settings, rect, notes, prepared, parallel, progress));
  if (uses_environment(inputs.settings, scene))
    inputs.environment = environment_maps(scene, inputs.settings, prepared, parallel.priority, progress);
}

template void add_maps(RasterInputs<float>&, const Scene&, const View&, const TileRect&, StencilNotes, Prepared&,
                       const ParallelOptions&, Progress&);
template void add_maps(RasterInputs<double>&, const Scene&, const View&, const TileRect&, StencilNotes, Prepared&,
                       const ParallelOptions&, Progress&);

template <class Real>
void store_map_pictures(const RasterInputs<Real>& inputs, Frame& frame) {
  if (inputs.shadow_maps && !frame.shadow_map.empty()) lay_out_maps(*inputs.shadow_maps, frame.shadow_map);
  if (inputs.environment && !frame.environment.empty()) {
    const auto first =
        std::find_if(inputs.environment->begin(), inputs.environment->end(), [](const auto& m) { return m; });
    if (first != inputs.environment->end()) lay_out_environment(**first, frame.environment);
  }
  if (!inputs.stencil) return;
  frame.counters += inputs.stencil->counters;
  if (frame.stencil.empty()) return;
  for (std::size_t light = 0; light < inputs.stencil->counts.size(); ++light) {
    const int shown = inputs.settings.light_shown;
    if (shown != all_lights && static_cast<int>(light) != shown) continue;
    const Image<std::int32_t>& counts = inputs.stencil->counts[light];
    for (std::size_t i = 0; i < counts.pixels().size(); ++i) frame.stencil.pixels()[i] += counts.pixels()[i];
  }
}

template void store_map_pictures(const RasterInputs<float>&, Frame&);
template void store_map_pictures(const RasterInputs<double>&, Frame&);

}  // namespace ps::raster
