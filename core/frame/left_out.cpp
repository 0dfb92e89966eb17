#include "frame/left_out.h"

namespace ps {

bool asks_for_shadows(const SceneTraits& traits, const Settings& settings) {
  return settings.lighting && settings.draw == Draw::filled && traits.casting_lights &&
         settings.shadows != Shadows::none;
}

bool asks_for_reflections(const SceneTraits& traits, const Settings& settings) {
  return traits.reflective && settings.draw == Draw::filled && settings.reflection_depth > 0;
}

}  // namespace ps
