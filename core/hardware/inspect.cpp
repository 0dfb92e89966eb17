#include <fmt/format.h>

#include "hardware/gl_thread.h"
#include "hardware/render.h"
#include "hardware/story_drawer.h"

namespace ps::hardware {

PixelStory inspect_hardware(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress) {
  const Driver& driver = require_driver(view);
  PixelStory story;
  story.pixel = pixel;
  story.renderer = settings.renderer;
  RenderRequest request;
  request.region = TileRect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  PicturePlan plan = make_plan(scene, view, settings, request, prepared);
  draw_ahead(plan, prepared, request.priority, progress, [](const char*) {});
  on_gl_thread([&](Workshop& shop) {
    shop.tidy();
    StoryDrawer(plan, shop, pixel).report(story);
  });
  progress.check();
  story.not_reported = fmt::format("Drawn again triangle by triangle by {}. A graphics driver does not report edge "
                                   "values, which triangle owns an edge, "
                                   "or how it clips.",
                                   driver.renderer);
  return story;
}

}  // namespace ps::hardware
