#include "render/left_out.h"

namespace ps {

std::vector<std::string> left_out(const Scene& scene, const Settings& settings) {
  if (settings.renderer != Renderer::rasterizer) return {};
  const SceneTraits traits = scene_traits(scene);
  std::vector<std::string> sentences;
  if (traits.csg)
    sentences.push_back(
        "The rasterizer leaves out objects made by CSG: their surface is only known ray by ray, not as triangles.");
  if (traits.transparent)
    sentences.push_back("The rasterizer shows transparent surfaces opaque: it follows no light through them.");
  return sentences;
}

}  // namespace ps
