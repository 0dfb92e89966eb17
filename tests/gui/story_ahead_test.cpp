// The story that is asked for before a click: once for each scene and settings, and no failure of it is shown.
#include "gui/work/story_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/check.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::gui::story_ahead_test {
namespace {

PictureRequest pictured(const char* name) {
  PictureRequest picture;
  picture.scene = load_scene(name);
  picture.settings = settings_for(picture.scene);
  picture.view = {picture.scene.camera, 20, 20};
  return picture;
}

TEST(StoryAhead, IsAskedForOnceForEachSceneAndSettings) {
  std::atomic<int> asked = 0;
  {
    StoryAhead ahead([&](const Scene&, const View&, const Settings&, Vec2i, Prepared&, Progress&) -> PixelStory {
      ++asked;
      throw InputError("no story");
    });
    const auto prepared = std::make_shared<Prepared>();
    const auto expect_asked = [&](int times, const PictureRequest& picture, Vec2i pixel) {
      ahead.prepare(picture, pixel, prepared);
      for (int i = 0; i < 1000 && asked < times; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // one that is not wanted would come now
      EXPECT_EQ(asked, times);
    };
    PictureRequest picture = pictured("cgfs/cubes");
    expect_asked(1, picture, {3, 4});
    picture.view.camera.position.x += 1;
    expect_asked(1, picture, {5, 6});
    picture.settings.backface_culling = !picture.settings.backface_culling;
    expect_asked(2, picture, {5, 6});
    expect_asked(3, pictured("cgfs/crates"), {5, 6});
  }
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace ps::gui::story_ahead_test
