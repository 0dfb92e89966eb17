#include "render/left_out.h"

namespace ps {

std::vector<LeftOut> left_out(const SceneTraits& traits, const Settings& settings) {
  if (settings.renderer != Renderer::rasterizer) return {};
  std::vector<LeftOut> all;
  if (traits.csg)
    all.push_back(
        {"leaves out CSG",
         "The rasterizer leaves out objects made by CSG: their surface is only known ray by ray, not as triangles."});
  if (traits.transparent)
    all.push_back(
        {"shows glass opaque", "The rasterizer shows transparent surfaces opaque: it follows no light through them."});
  return all;
}

}  // namespace ps
