// fast_path() decides who may draw fast. What it says is held to what the kernels did, and to the work they counted:
// SIMD searches visit a tree of their own, and batches of fragments need no scalar code for their depth.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "options/simd_choice.h"
#include "render/fast_path.h"
#include "scene/load.h"
#include "support/emulated.h"
#include "support/option_contexts.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::fast_path_test {
namespace {

constexpr int width = 24, height = 18;

/// A choice's or a toggle's values, of a number another one than `now`.
std::vector<OptionNumber> values_of(const Option& option, const Settings& settings) {
  const OptionNumber now = option.get(settings);
  if (option.kind == OptionKind::integer || option.kind == OptionKind::real)
    return {now, std::clamp(2 * now + 1, option.minimum, std::min(option.maximum, 64.0))};
  std::vector<OptionNumber> values;
  const double last = option.kind == OptionKind::boolean ? 1 : static_cast<double>(option.choices.size()) - 1;
  for (double value = 0; value <= last; ++value) values.push_back(value);
  return values;
}

/// The key of the code path that drew the picture.
std::string_view expect_drawn_as_predicted(const Scene& scene, const SceneTraits& traits, const Settings& settings,
                                           Channel channels, Prepared& prepared) {
  const FastPath predicted = fast_path(settings, traits, channels);
  Progress progress;
  const Frame frame = render(scene, {scene.camera, width, height}, settings, request_for(channels), prepared, progress);
  EXPECT_EQ(machinery_key(frame.path.machinery), machinery_key(predicted.machinery)) << predicted.reason;
  // Where every surface asks for scalar shading, nothing is left for SIMD.
  const bool none_left = predicted.shading == SurfaceShading::mixed && frame.path.shading == SurfaceShading::single;
  if (!none_left) {
    EXPECT_EQ(shading_key(frame.path.shading), shading_key(predicted.shading)) << predicted.reason;
  }
  // Of a graphics driver the reason is its name.
  const bool fastest = predicted.shading == SurfaceShading::lanes &&
                       predicted.machinery != Machinery::fragment_batches && predicted.machinery != Machinery::driver;
  EXPECT_EQ(predicted.reason.empty(), fastest) << predicted.reason;
  return machinery_key(frame.path.machinery);
}

// Every value of every option that can act in a context, in one of them at least.
TEST(FastPath, IsWhatDrawsInAllOptionContexts) {
  std::set<std::string_view> seen;
  for (const test::OptionContext& context : test::option_contexts()) {
    const Scene scene = load_scene(context.scene);
    const SceneTraits traits = scene_traits(scene);
    Prepared prepared;
    Settings base = settings_with(settings_for(scene), context.assignments);
    for (const Channel channels : {Channel::ids | Channel::depth, Channel::normal, Channel::tests, Channel::samples})
      seen.insert(expect_drawn_as_predicted(scene, traits, base, channels, prepared));
    for (std::size_t i = 0; i < option_table().size(); i += test::trial_step()) {
      const Option& option = option_table()[i];
      if (inactive_reason(option, base, traits)) continue;
      for (const OptionNumber value : values_of(option, base)) {
        Settings settings = base;
        option.set(settings, value);
        const RendererKind& kind = renderer_kind(settings.renderer);
        if (kind.inactive && kind.inactive(settings, traits)) continue;  // no driver here
        // A number that a driver lacks is refused.
        if (option.kind != OptionKind::choice && inactive_value_reason(option, settings, traits)) continue;
        SCOPED_TRACE(fmt::format("{}, {}={}", context.scene, option.key, option_text(option, settings)));
        seen.insert(expect_drawn_as_predicted(scene, traits, settings, Channel::none, prepared));
      }
    }
  }
  if (!widest_simd(Simd::automatic)) GTEST_SKIP() << "this processor has no SSE4: all is drawn by scalar code";
  if (test::is_emulated()) return;  // too few of them were tried
  EXPECT_EQ(seen.size(), test::has_renderer("hardware") ? 6u : 5u) << "the contexts reach every code path";
}

Frame drawn(const std::string& name, const std::vector<std::string>& assignments,
            const std::optional<TileRect>& region = {}) {
  const Scene scene = load_scene(name);
  Settings settings = settings_with(settings_for(scene), assignments);
  return render(scene, {scene.camera, width, height}, settings, request_for(Channel::none, region));
}

// The work that was counted shows which code ran: SIMD searches for triangles visit a tree of their own.
TEST(FastPath, CountsShowWhichCodeRan) {
  if (!widest_simd(Simd::automatic)) GTEST_SKIP() << "this processor has no SSE4";
  const auto nodes = [](const Frame& frame) { return frame.counters[Counter::node_visits]; };
  const Frame simd = drawn("cgfs/shading", {}), scalar = drawn("cgfs/shading", {"simd=off"});
  EXPECT_EQ(machinery_key(simd.path.machinery), "wide-triangles");
  EXPECT_EQ(machinery_key(scalar.path.machinery), "clear");
  EXPECT_EQ(scalar.path.reason, "simd = off");
  EXPECT_NE(nodes(simd), nodes(scalar));
  const Frame boxed = drawn("cgfs/shading", {"accelerator=box"}),
              off = drawn("cgfs/shading", {"accelerator=box", "simd=off"});
  EXPECT_EQ(machinery_key(boxed.path.machinery), "clear");
  EXPECT_EQ(boxed.counters, off.counters);
}

TEST(FastPath, ReasonsNameWhatIsMissing) {
  if (!widest_simd(Simd::automatic)) GTEST_SKIP() << "this processor has no SSE4";
  const auto reason = [](const std::string& scene, const std::vector<std::string>& assignments) {
    return std::string(drawn(scene, assignments).path.reason);
  };
  EXPECT_EQ(reason("cgfs/reflections", {}), "");
  EXPECT_EQ(reason("cgfs/reflections", {"self-hit=epsilon"}), "packets need self-hit = offset");
  EXPECT_EQ(reason("cgfs/reflections", {"precision=double"}), "needs precision = float");
  EXPECT_EQ(reason("cgfs/crates", {"renderer=rasterizer", "multisampling=4"}), "SIMD needs multisampling = 1");
  EXPECT_EQ(reason("cgfs/crates", {"renderer=rasterizer", "visibility=painter"}),
            "whole tiles need visibility = depth-buffer");
  EXPECT_EQ(drawn("cgfs/crates", {"renderer=rasterizer"}, TileRect{4, 4, 20, 20}).path.reason,
            "the tiled SIMD path needs the whole picture");
}

}  // namespace
}  // namespace ps::fast_path_test
