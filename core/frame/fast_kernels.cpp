#include "frame/fast_kernels.h"

#include "options/fast_limits.h"

namespace ps {

std::string_view no_simd_reason(const Settings& settings) { return fast_limit(FastCode::any, settings, {}); }

SceneTraits prepared_traits(const Scene& scene, Prepared& prepared) {
  return *prepared.get<SceneTraits>(Key("scene traits").add(scene.revision()), [&] { return scene_traits(scene); });
}

}  // namespace ps
