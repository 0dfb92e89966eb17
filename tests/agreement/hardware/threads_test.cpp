// The hardware renderer has one thread with a context; pictures may be asked for from any.
#include <gtest/gtest.h>

#include <thread>

#include "agreement/hardware/hardware_pair.h"
#include "base/check.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps {
namespace {

Settings hardware_settings(const Scene& scene, Renderer hardware) {
  Settings settings = settings_for(scene, hardware);
  return settings;
}

TEST(HardwareThreads, PicturesOfSeveralThreadsAreThoseOfOne) {
  PS_NEEDS_HARDWARE(hardware);
  const std::vector<std::string> names{"cgfs/shading", "cgfs/crates", "cgpp/triangle", "octree/attenuation"};
  std::vector<Scene> scenes;
  std::vector<Frame> alone, together(names.size() * 4);
  for (const std::string& name : names) {
    scenes.push_back(load_scene(name));
    alone.push_back(render(scenes.back(), {scenes.back().camera, 120, 90}, hardware_settings(scenes.back(), hardware)));
  }
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < together.size(); ++i)
    threads.emplace_back([&, i] {
      const Scene& scene = scenes[i % names.size()];
      together[i] = render(scene, {scene.camera, 120, 90}, hardware_settings(scene, hardware));
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < together.size(); ++i)
    EXPECT_EQ(together[i].colour, alone[i % names.size()].colour) << names[i % names.size()];
}

TEST(HardwareThreads, AnErrorReachesItsCallerAndTheNextPictureIsDrawn) {
  PS_NEEDS_HARDWARE(hardware);
  EXPECT_THROW(hardware::on_gl_thread([](hardware::Workshop&) { throw InputError("planted"); }), InputError);
  const Scene scene = load_scene("cgfs/crates");
  const Frame frame = render(scene, {scene.camera, 40, 30}, hardware_settings(scene, hardware));
  EXPECT_GT(frame.counters.get(Counter::pixels_written).value(), 100u);
}

TEST(HardwareThreads, AStopEndsThePicture) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/shading");
  Prepared prepared;
  Progress progress;
  progress.request_stop();
  EXPECT_THROW(render(scene, {scene.camera, 40, 30}, hardware_settings(scene, hardware), {}, prepared, progress),
               Cancelled);
}

TEST(HardwareThreads, ChannelsChangeNothing) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/crates");
  const View view{scene.camera, 120, 90};
  const Settings settings = hardware_settings(scene, hardware);
  const Frame frame = render(scene, view, settings);
  const Frame with_ids = render(scene, view, settings, request_for(Channel::ids));
  EXPECT_EQ(frame.colour, with_ids.colour) << "channels must not change a bit of the picture";
}

}  // namespace
}  // namespace ps
