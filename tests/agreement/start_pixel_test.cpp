// The pixel that a scene's inspector opens on shows something, whichever renderer draws it.
#include <algorithm>

#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::start_pixel_test {
namespace {

PixelStory story_of(const Scene& scene, Renderer renderer) {
  Settings settings = settings_for(scene, renderer);
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  return inspect(scene, view, settings, scene.start_pixel);
}

TEST(StartPixel, ShowsSomethingInBothRenderers) {
  for (const auto& listed : builtin_scenes()) {
    SCOPED_TRACE(listed.name);
    const Scene scene = load_scene(listed.name);
    if (!scene_traits(scene).csg) {  // the rasterizer leaves CSG out and says so
      const PixelStory drawn = story_of(scene, Renderer::rasterizer);
      EXPECT_TRUE(!events_of<WriteEvent>(drawn.events).empty() || !events_of<LineEvent>(drawn.events).empty())
          << drawn.verdict;
    }
    if (scene.geometry->objects.empty()) continue;  // shapes on the canvas are not for rays
    const PixelStory traced = story_of(scene, Renderer::ray_tracer);
    EXPECT_FALSE(events_of<HitEvent>(traced.events).empty()) << traced.verdict;
  }
}

}  // namespace
}  // namespace ps::start_pixel_test
