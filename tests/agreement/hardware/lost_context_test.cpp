// A context that is lost ends one picture with a message. The other renderers go on, and so does this one, with a new
// context: its pictures and stories are what they were.
#include <gtest/gtest.h>

#include <algorithm>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/refusal.h"
#include "support/render_once.h"

namespace ps::lost_context_test {
namespace {

struct Pictured {
  Scene scene = load_scene("cgfs/crates");
  View view{scene.camera, 60, 60};
  Settings settings = settings_for(scene);

  explicit Pictured(Renderer renderer) { settings.renderer = renderer; }
  Frame draw() { return render(scene, view, settings); }
  PixelStory story() { return inspect(scene, view, settings, {34, 13}); }
};

void lose_context() {
  hardware::on_gl_thread([](hardware::Workshop& shop) { shop.context.lose(); });
}

TEST(LostContext, EndsOnePictureAndNoMore) {
  PS_NEEDS_HARDWARE(hardware);
  Pictured drawn(hardware), rasterized(Renderer::rasterizer);
  const Frame before = drawn.draw(), ours = rasterized.draw();
  const PixelStory story = drawn.story();
  const std::string lost = "the graphics driver has lost its context; the next picture starts a new one";
  for (const bool while_inspecting : {false, true}) {
    lose_context();
    EXPECT_EQ(test::refusal_of([&] { while_inspecting ? (void)drawn.story() : (void)drawn.draw(); }), lost);
    EXPECT_TRUE(std::ranges::equal(rasterized.draw().colour.pixels(), ours.colour.pixels()));
    EXPECT_TRUE(std::ranges::equal(drawn.draw().colour.pixels(), before.colour.pixels()));
    const PixelStory again = drawn.story();
    EXPECT_EQ(again.linear, story.linear);
    EXPECT_EQ(again.events.size(), story.events.size());
  }
}

}  // namespace
}  // namespace ps::lost_context_test
