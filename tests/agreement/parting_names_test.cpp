// A picture by rays and one by triangles agree at a pixel until one option is changed in one of them: then the sentence
// about where their stories part names this option, and not what the two renderers do differently anyway.
#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/enumerators.h"
#include "frame/display_frame.h"
#include "inspect/parting/parting.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::parting_names_test {
namespace {

constexpr int width = 96, height = 72;
constexpr int same_levels = 2, other_levels = 24;  // of 255
constexpr std::size_t pixels_of_each = 4;

/// Greatest difference of a channel, in levels of 255.
int difference(const Rgb8& x, const Rgb8& y) {
  return std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)});
}

std::vector<OptionNumber> other_values(const Option& option, const Settings& settings) {
  const OptionNumber now = option.get(settings);
  std::vector<OptionNumber> values;
  switch (option.kind) {
  case OptionKind::boolean:
    return {1 - now};
  case OptionKind::choice:
    for (std::size_t i = 0; i < option.choices.size(); ++i) values.push_back(static_cast<OptionNumber>(i));
    break;
  case OptionKind::integer:
  case OptionKind::real:
    values = {std::clamp(now * 2 + 1, option.minimum, option.maximum), option.minimum};
  }
  std::erase(values, now);
  return values;
}

/// What one of two renderers does and the other does not, or does differently: no cause where it did no harm before the
/// option was changed. Others (a mirrored ray, another mip level, a back face) are the first step that differs even
/// where it makes no difference to the colour.
bool is_of_the_renderers(PartingCause cause) {
  static const std::set<PartingCause> all{
      PartingCause::silhouette,     PartingCause::tessellation, PartingCause::shading_position,
      PartingCause::light_model,    PartingCause::coverage,     PartingCause::visibility,
      PartingCause::missing_shadow, PartingCause::clipping,     PartingCause::unexplained,
  };
  return all.count(cause) > 0;
}

/// A scene with its pictures by both renderers.
struct Pair {
  Scene scene;
  View view;
  Settings settings[2];
  Image<Rgb8> pictures[2];
  Prepared prepared;
  Progress progress;

  explicit Pair(const char* name) : scene(load_scene(name)), view{scene.camera, width, height} {
    for (const int i : {0, 1}) {
      settings[i] = settings_for(scene);
      settings[i].renderer = i == 0 ? Renderer::ray_tracer : Renderer::rasterizer;
      pictures[i] = picture(settings[i]);
    }
  }

  Image<Rgb8> picture(const Settings& with) {
    return display_frame(render(scene, view, with, {}, prepared, progress), with);
  }

  /// Pixels where the picture agrees with the other renderer's before the change and not after it.
  std::vector<Vec2i> changed_pixels(int changed_side, const Image<Rgb8>& changed) const {
    const Image<Rgb8>&kept = pictures[1 - changed_side], &before = pictures[changed_side];
    std::vector<Vec2i> all, chosen;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (difference(kept.at(x, y), before.at(x, y)) <= same_levels &&
            difference(kept.at(x, y), changed.at(x, y)) >= other_levels)
          all.push_back({x, y});
    const std::size_t step = std::max<std::size_t>(all.size() / pixels_of_each, 1);
    for (std::size_t i = step / 2; i < all.size(); i += step) chosen.push_back(all[i]);
    return chosen;
  }
};

struct Named {
  int right = 0;
  std::vector<std::string> wrong;  ///< sentences that name the option nowhere
};

void look_at(Pair& pair, const Option& option, int side, OptionNumber value, Named& named) {
  const SceneTraits traits = scene_traits(pair.scene);
  Settings changed = pair.settings[side];
  option.set(changed, value);
  if (inactive_reason(option, changed, traits) || inactive_value_reason(option, changed, traits)) return;
  for (const Vec2i& pixel : pair.changed_pixels(side, pair.picture(changed))) {
    const Settings& kept = pair.settings[1 - side];
    const PixelStory a = inspect(pair.scene, pair.view, kept, pixel, pair.prepared, pair.progress);
    const PixelStory b = inspect(pair.scene, pair.view, changed, pixel, pair.prepared, pair.progress);
    const Parting parting = find_parting(pair.scene, {a, kept}, {b, changed});
    if (!is_of_the_renderers(parting.cause)) continue;
    if (parting.sentence.find(std::string(option.key) + " is ") != std::string::npos)
      ++named.right;
    else
      named.wrong.push_back(fmt::format("{}={} in {}'s picture, pixel {},{} [{}]: {}", option.key,
                                        option_text(option, changed), side == 0 ? "the ray tracer" : "the rasterizer",
                                        pixel.x, pixel.y, enumerator_key(parting.cause), parting.sentence));
  }
}

class PartingNames : public testing::TestWithParam<const char*> {};

TEST_P(PartingNames, TheOptionThatMadeTheDifference) {
  Pair pair(GetParam());
  static const std::set<std::string_view> groups{"Camera", "Sampling", "Visibility", "Drawing", "Shading", "Shadows"};
  Named named;
  for (const Option& option : option_table()) {
    if (groups.count(option.group) == 0 || option.effect != OptionEffect::picture) continue;
    for (const int side : {0, 1}) {
      if (inactive_reason(option, pair.settings[side], scene_traits(pair.scene))) continue;
      for (const OptionNumber value : other_values(option, pair.settings[side]))
        look_at(pair, option, side, value, named);
    }
  }
  EXPECT_GT(named.right, 20);  // else nothing was compared
  EXPECT_TRUE(named.wrong.empty()) << named.right << " right, " << named.wrong.size() << " wrong:\n"
                                   << fmt::format("{}", fmt::join(named.wrong, "\n"));
}

INSTANTIATE_TEST_SUITE_P(All, PartingNames,
                         testing::Values("cgfs/reflections", "cgfs/spheres", "cgfs/shading", "cgfs/shadows",
                                         "cgfs/cubes", "cgfs/lights", "cgfs/crates", "cgpp/ground", "cgpp/teapot",
                                         "lab/stacked-shadows"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

}  // namespace
}  // namespace ps::parting_names_test
