#include "hardware/draw_passes.h"

#include "raster/setup/draw_stage.h"

namespace ps::hardware {

bool lights_separately(const PicturePlan& plan) {
  if (plan.lights.empty()) return false;
  const bool maps_by_light = plan.maps_shadows && plan.settings.shading != Shading::phong;
  return raster::lights_one_by_one(plan.settings) || plan.counts_volumes || maps_by_light;
}

int first_light(const PicturePlan& plan) {
  return plan.counts_volumes || (plan.term_colours && lights_separately(plan)) ? -1 : 0;
}

std::vector<DrawPass> draw_passes(const PicturePlan& plan) {
  using Kind = DrawPass::Kind;
  const Settings& s = plan.settings;
  if (!lights_separately(plan)) {
    if (plan.defers) return {{Kind::geometry}, {Kind::shade, -1, false, true}};
    if (raster::has_passes(s) && s.early_depth) return {{Kind::depth}, {Kind::shade, -1, false, true}};
    return {{Kind::whole, -1, false, true}};
  }
  std::vector<DrawPass> passes{{plan.defers ? Kind::geometry : Kind::depth}};
  // A stencil buffer lets no fragment of a shadow through, so what is there without light must be drawn before.
  if (first_light(plan) < 0) passes.push_back({Kind::light, -1, false, true});
  const bool counts_each = raster::lights_one_by_one(s) && !plan.counts_volumes;
  for (std::size_t i = 0; i < plan.lights.size(); ++i) {
    const bool adds = passes.size() > 1;
    passes.push_back({Kind::light, static_cast<int>(i), adds, counts_each || !adds});
  }
  return passes;
}

}  // namespace ps::hardware
