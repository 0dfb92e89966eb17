#include "support/shown_levels.h"

#include "frame/display_frame.h"
#include "image/difference.h"
#include "render/render.h"

namespace ps::test {

Image<Rgb8> levels_of(const Scene& scene, const Settings& settings, int width, int height) {
  return display_frame(render(scene, {scene.camera, width, height}, settings), settings);
}

int differing(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) count += largest_difference(a.pixels()[i], b.pixels()[i]) > 2;
  return count;
}

}  // namespace ps::test
