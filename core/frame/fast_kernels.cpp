#include "frame/fast_kernels.h"

#include "options/simd_choice.h"

namespace ps {

std::string_view no_simd_reason(const Settings& settings) {
  if (settings.precision != Precision::float32) return "needs precision = float";
  if (settings.simd == Simd::off) return "simd = off";
  if (!widest_simd(settings.simd)) return "this processor has no SSE4";
  return "";
}

SceneTraits prepared_traits(const Scene& scene, Prepared& prepared) {
  return *prepared.get<SceneTraits>(Key("scene traits").add(scene.revision()), [&] { return scene_traits(scene); });
}

}  // namespace ps
