#include "raster/shadow/store_map_pictures.h"

#include <algorithm>

#include "raster/shadow/map_picture.h"

namespace ps::raster {

template <class Real>
void store_map_pictures(const Pass<Real>& pass, Frame& frame) {
  if (pass.shadow_maps && !frame.shadow_map.empty()) lay_out_maps(*pass.shadow_maps, frame.shadow_map);
  if (pass.environment && !frame.environment.empty()) {
    const auto first =
        std::find_if(pass.environment->begin(), pass.environment->end(), [](const auto& m) { return m; });
    if (first != pass.environment->end()) lay_out_environment(**first, frame.environment);
  }
  if (!pass.stencil) return;
  frame.counters += pass.stencil->counters;
  if (frame.stencil.empty()) return;
  for (std::size_t light = 0; light < pass.stencil->counts.size(); ++light) {
    const int shown = pass.settings.light_shown;
    if (shown != all_lights && static_cast<int>(light) != shown) continue;
    const Image<std::int32_t>& counts = pass.stencil->counts[light];
    for (std::size_t i = 0; i < counts.pixels().size(); ++i) frame.stencil.pixels()[i] += counts.pixels()[i];
  }
}

template void store_map_pictures(const Pass<float>&, Frame&);
template void store_map_pictures(const Pass<double>&, Frame&);

}  // namespace ps::raster
