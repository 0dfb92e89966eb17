#include <gtest/gtest.h>

#include "base/paths.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/display_frame.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/random_scene.h"

namespace ps {
namespace {

/// A scene with settings under which some options can act.
struct Context {
  Scene scene;
  Settings settings;
};

Context context(Scene scene, const std::vector<std::string>& assignments) {
  Settings settings = settings_for(scene);
  for (const std::string& assignment : assignments) parse_assignment(assignment, settings);
  return {std::move(scene), settings};
}

Scene lesson_scene(const std::string& name) { return load_scene((chapter_dir() / "cgfs_14_textures" / name).string()); }

const std::vector<Context>& contexts() {
  static const std::vector<Context> all{
      context(load_scene("cgfs/reflections"), {}),
      context(load_scene("cgfs/reflections"), {"self-hit=epsilon"}),
      context(load_scene("cgfs/reflections"), {"self-hit=epsilon", "shadow-epsilon=0.1"}),
      context(load_scene("cgfs/reflections"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/shading"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/shading"), {"triangle-test=moeller-trumbore"}),
      context(load_scene("cgfs/shading"), {"triangle-test=moeller-trumbore", "triangle-epsilon=1"}),
      context(load_scene("cgfs/crates"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/depth"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/lines"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/wireframe"), {"renderer=rasterizer"}),
      context(load_scene("cgfs/cubes"), {"renderer=rasterizer", "subpixel-bits=0"}),
      context(lesson_scene("floor.scene"), {"renderer=rasterizer"}),
      context(lesson_scene("closeup.scene"), {"renderer=rasterizer", "texture-filter=bilinear"}),
      context(test::random_scene(1), {}),
      context(test::random_scene(1), {"renderer=rasterizer"}),
      context(test::random_scene(2), {"renderer=rasterizer", "normals=vertex"}),
  };
  return all;
}

struct Outcome {
  Image<Rgb8> picture;
  Counters counters;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome(const Scene& scene, const Settings& settings, Prepared& prepared) {
  Progress progress;
  const Frame frame = render(scene, {scene.camera, 96, 72}, settings, {}, prepared, progress);
  return {display_frame(frame, settings), frame.counters};
}

std::vector<double> other_values(const Option& option, const Settings& settings) {
  const double now = option.get(settings);
  std::vector<double> values;
  if (option.kind == OptionKind::boolean) return {1 - now};
  if (option.kind == OptionKind::choice) {
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<double>(i));
  } else {
    values = {option.minimum, option.maximum, std::max(option.minimum, std::min(option.maximum, now * 2 + 1))};
  }
  std::erase(values, now);
  return values;
}

/// Whether some value of the option changes a picture or a counter in some context where it says that it can act.
bool acts(const Option& option) {
  for (const Context& context : contexts()) {
    if (inactive_reason(option, context.settings, scene_traits(context.scene))) continue;
    Prepared prepared;
    const Outcome before = outcome(context.scene, context.settings, prepared);
    for (const double value : other_values(option, context.settings)) {
      Settings changed = context.settings;
      option.set(changed, value);
      if (!(outcome(context.scene, changed, prepared) == before)) return true;
    }
  }
  return false;
}

// A toggle that does nothing anywhere is a lie in the panel. Threads and SIMD change nothing but time, by design.
TEST(Options, EachChangesAPictureOrACounterSomewhere) {
  for (const Option& option : option_table()) {
    const bool only_time = option.key == "threads" || option.key == "simd";
    EXPECT_EQ(acts(option), !only_time) << option.key;
  }
}

}  // namespace
}  // namespace ps
