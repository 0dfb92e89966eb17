#include "agreement/hardware/hardware_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "image/difference.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"

namespace ps::test {

std::optional<Renderer> hardware_here(std::string& reason) {
  reason = hardware::availability().reason;
  if (!hardware::availability().driver) return {};
  Settings settings;
  parse_assignment("renderer=hardware", settings);
  return settings.renderer;
}

bool drawn_by_llvmpipe() {
  const auto& driver = hardware::availability().driver;
  return driver && driver->renderer.starts_with("llvmpipe");
}

std::string PairDifference::text() const {
  return fmt::format("{} of {} pixels seen; {} ids and {} colours differ, by {} levels at most", seen, pixels, ids,
                     colours, largest);
}

namespace {

/// A scene and what its pictures share: shadow maps of many cases are the same.
struct LoadedScene {
  explicit LoadedScene(const std::string& name) : scene(load_scene(name)) {}
  Scene scene;
  Prepared prepared;
};

LoadedScene& loaded(const std::string& name) {
  static std::map<std::string, LoadedScene> all;
  return all.try_emplace(name, name).first->second;
}

PairDifference compare(const Scene& scene, const Settings& settings, Renderer hardware, const View& view,
                       Prepared& prepared) {
  RenderRequest request;
  request.channels = Channel::ids;
  Progress progress;
  Settings one = settings;
  one.renderer = hardware;
  Settings other = settings;
  other.renderer = Renderer::rasterizer;
  other.subpixel_bits = hardware::availability().driver->subpixel_bits;
  const Frame drawn = render(scene, view, one, request, prepared, progress);
  const Frame expected = render(scene, view, other, request, prepared, progress);
  const Image<Rgb8> a = display_frame(drawn, one), b = display_frame(expected, other);
  PairDifference difference;
  difference.pixels = static_cast<long>(a.pixels().size());
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    if (drawn.ids.pixels()[i] != expected.ids.pixels()[i]) {
      ++difference.ids;
      continue;
    }
    difference.seen += expected.ids.pixels()[i].object >= 0;
    const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
    const int levels = largest_difference(p, q);
    difference.colours += levels > 1;
    difference.largest = std::max(difference.largest, levels);
  }
  return difference;
}

}  // namespace

PairDifference compare_with_rasterizer(const Scene& scene, const Settings& settings, Renderer hardware, int width,
                                       int height) {
  Prepared prepared;
  return compare(scene, settings, hardware, {scene.camera, width, height}, prepared);
}

std::string PairCase::name() const {
  std::string text = scene;
  for (const std::string& assignment : assignments) text += " " + assignment;
  return text;
}

PairDifference compare_with_rasterizer(const PairCase& one, Renderer hardware, int width, int height) {
  LoadedScene& at_hand = loaded(one.scene);
  Settings settings = settings_with(settings_for(at_hand.scene), one.assignments);
  return compare(at_hand.scene, settings, hardware, {at_hand.scene.camera, width, height}, at_hand.prepared);
}

}  // namespace ps::test
