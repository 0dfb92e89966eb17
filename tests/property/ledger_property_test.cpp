// The colour as a sum: for random pixels of every built-in scene under random options, the lines of the ledger add up
// to the number that the renderer stored, to the last bit, and what is put down to rounding is no more than rounding.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/random_settings.h"
#include "support/trials.h"

namespace ps::ledger_property_test {
namespace {

using Random = std::mt19937;
using test::below;
using test::random_value;
using test::share;

constexpr int width = 40, height = 30, option_sets = test::trial_divisor > 1 ? 2 : 6, pixels_each = 10;
constexpr std::size_t scene_step = test::trial_divisor > 1 ? 2 : 1;

Settings random_settings(Settings settings, Random& random) {
  const Renderer renderer = settings.renderer;
  for (const Option& option : option_table())
    if (share(random) < 0.12) option.set(settings, random_value(option, random));
  settings.renderer = renderer;
  settings.threads = 1;
  return settings;
}

Vec3d total(const PixelStory& story) {
  Vec3d sum{0, 0, 0};
  for (const LedgerLine& line : story.ledger)
    if (line.level == 0) sum += line.value;
  return sum;
}

double size_of(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// What is wrong with the lines; empty if nothing. Every line that has lines below it is their sum, and no line of
/// rounding is large. `parents` counts the former.
std::string fault_of_lines(const PixelStory& story, const Settings& settings, int& parents) {
  double scale = 1e-3;
  for (const LedgerLine& line : story.ledger)
    if (line.level == 0) scale += size_of(line.value);
  // Sums of a few hundred products at most; a share of a ray rounds once more at each bounce.
  const double slack = (settings.precision == Precision::float64 ? 1e-12 : 2e-5) * scale;
  for (std::size_t i = 0; i < story.ledger.size(); ++i) {
    const LedgerLine& line = story.ledger[i];
    if (line.term.starts_with("rounding") && size_of(line.value) > slack)
      return fmt::format("rounding of {} where {} are allowed", size_of(line.value), slack);
    Vec3d sum{0, 0, 0};
    bool any = false;
    for (std::size_t k = i + 1; k < story.ledger.size() && story.ledger[k].level > line.level; ++k)
      if (story.ledger[k].level == line.level + 1) {
        sum += story.ledger[k].value;
        any = true;
      }
    if (!any) continue;
    ++parents;
    if (size_of(sum - line.value) > 2e-5 * scale)
      return fmt::format("'{}' is off from its parts by {}", line.term, size_of(sum - line.value));
  }
  return {};
}

std::string fault_of_story(const PixelStory& story, const Frame& frame, const Settings& settings, int& parents) {
  const Vec3d stored = linear_at(frame, story.pixel);
  if (story.linear != stored) return "the story has another colour than the picture";
  if (total(story) != stored) return fmt::format("the sum is off by {}", size_of(total(story) - stored));
  const Rgb8 levels = display_at(frame, settings, story.pixel);
  if (story.display != std::array<int, 3>{levels.r, levels.g, levels.b}) return "other display levels";
  return fault_of_lines(story, settings, parents);
}

TEST(Ledger, AddsUpToThePictureEverywhere) {
  const unsigned seed = test::test_seed(20261121);  // another seed tries other pixels and options
  Random random(seed);
  int pixels = 0, parents = 0, lit = 0;
  std::vector<std::string> faults;
  for (std::size_t number = 0; number < builtin_scenes().size(); number += scene_step) {
    const BuiltinScene& builtin = builtin_scenes()[number];
    const Scene scene = load_scene(builtin.name);
    const View view{scene.camera, width, height};
    Prepared prepared;
    Progress progress;
    for (int set = 0; set < 2 * option_sets; ++set) {
      Settings settings = settings_for(scene);
      settings.renderer = set % 2 == 0 ? Renderer::ray_tracer : Renderer::rasterizer;
      settings.threads = 1;
      if (set > 1) settings = random_settings(settings, random);
      const Frame frame = render(scene, view, settings, {}, prepared, progress);
      for (int i = 0; i < pixels_each; ++i) {
        const Vec2i pixel(below(random, width), below(random, height));
        if (!(size_of(linear_at(frame, pixel)) < 1e30)) continue;  // NaN and infinity add up to nothing
        const PixelStory story = inspect(scene, view, settings, pixel, prepared, progress);
        ++pixels;
        lit += story.ledger.size() > 3 ? 1 : 0;
        const std::string fault = fault_of_story(story, frame, settings, parents);
        if (fault.empty()) continue;
        faults.push_back(fmt::format("{}: {} at {},{}, settings{}", fault, builtin.name, pixel.x, pixel.y,
                                     test::changed_settings(settings)));
        break;  // one of each option set tells enough
      }
    }
  }
  std::string list;
  for (std::size_t i = 0; i < std::min<std::size_t>(faults.size(), 12); ++i) list += faults[i] + "\n";
  EXPECT_TRUE(faults.empty()) << faults.size() << " faults, seed " << seed << "\n" << list;
  EXPECT_GT(pixels, 340 * option_sets / static_cast<int>(scene_step)) << "seed " << seed;
  EXPECT_GT(parents, pixels / 4) << "seed " << seed;
  EXPECT_GT(lit, pixels / 4) << "seed " << seed;
}

}  // namespace
}  // namespace ps::ledger_property_test
