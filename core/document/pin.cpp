#include "document/pin.h"

#include <fmt/format.h>

#include "base/check.h"

namespace ps {

PinnedScene pinned_scene(const Pin& pin, const Scene& base) {
  PinnedScene then{edited_scene(base, pin.edits), {}};
  then.view = view_of(then.scene, pin.camera, pin.width, pin.height);
  if (pin.pixel.x < 0 || pin.pixel.y < 0 || pin.pixel.x >= then.view.width || pin.pixel.y >= then.view.height)
    throw InputError(fmt::format("pin: found pixel {},{}, expected one inside {} x {}", pin.pixel.x, pin.pixel.y,
                                 then.view.width, then.view.height));
  return then;
}

}  // namespace ps
