#include "render/fast_path.h"

#include "render/renderer_table.h"

namespace ps {

FastPath fast_path(const Settings& settings, const SceneTraits& traits, Channel channels) {
  return renderer_row(settings.renderer).fast_path(settings, traits, channels);
}

}  // namespace ps
