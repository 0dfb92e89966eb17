// An option that cannot act says what it needs, and setting that makes it act: for every row of the table, under many
// settings and in scenes of every kind.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "options/listing.h"
#include "options/scene_settings.h"
#include "options/waking.h"
#include "scene/load.h"
#include "support/settings_with.h"
#include "support/trials.h"

namespace ps {
namespace {

bool acts(const Option& option, const Settings& settings, const SceneTraits& traits) {
  return !inactive_reason(option, settings, traits) && !inactive_value_reason(option, settings, traits);
}

/// All, or a few under a sanitizer.
std::vector<BuiltinScene> scenes() {
  std::vector<BuiltinScene> some;
  for (std::size_t i = 0; i < builtin_scenes().size(); i += test::trial_divisor) some.push_back(builtin_scenes()[i]);
  return some;
}

/// Settings that switch much off.
const std::vector<std::vector<std::string>>& starts() {
  static const std::vector<std::vector<std::string>> all{
      {"renderer=ray-tracer"},
      {"renderer=rasterizer"},
      {"renderer=textbook"},
      {"renderer=rasterizer", "draw=wireframe"},
      {"renderer=rasterizer", "visibility=painter", "shading=flat", "lighting=off"},
      {"renderer=rasterizer", "coverage=scanline", "multisampling=4", "canvas-fill=rows"},
      {"renderer=rasterizer", "depth-value=z", "deferred-shading=on", "light-passes=many"},
      {"renderer=ray-tracer", "shadows=none", "reflection-depth=0", "refraction=off"},
      {"renderer=ray-tracer", "accelerator=none", "triangle-test=watertight", "textures=off"},
      {"renderer=ray-tracer", "samples-per-pixel=16", "sample-pattern=random", "specular=off"},
  };
  return all;
}

TEST(Waking, WhatIsOfferedMakesTheOptionAct) {
  int offered = 0;
  for (const BuiltinScene& builtin : scenes()) {
    const SceneTraits traits = scene_traits(load_scene(builtin.name));
    for (const auto& start : starts()) {
      const Settings settings = settings_with({}, start);
      for (const Option& option : option_table()) {
        const Waking waking = waking_of(option, settings, traits);
        if (acts(option, settings, traits)) {
          EXPECT_TRUE(waking.settings.empty() && waking.missing.empty()) << option.key;
          continue;
        }
        if (waking.settings.empty()) {
          EXPECT_FALSE(waking.missing.empty()) << option.key;
          continue;
        }
        ++offered;
        Settings woken = settings;
        wake(waking, woken);
        EXPECT_TRUE(acts(option, woken, traits))
            << builtin.name << ": " << option.key << " still cannot act after " << waking_text(waking);
        EXPECT_EQ(option.get(woken), option.get(settings)) << option.key << " itself was changed";
        for (const OptionValue& set : waking.settings) EXPECT_NE(set.option, &option);
      }
    }
  }
  EXPECT_GT(offered, 1000 / test::trial_divisor);
}

/// Options of a renderer that this program does not have act nowhere in it.
bool has_a_renderer(const Option& option) {
  for (std::size_t i = 0; i < renderer_kinds().size(); ++i) {
    const RendererKind& kind = renderer_kinds()[i];
    Settings settings;
    settings.renderer = static_cast<Renderer>(i);
    const std::optional<bool> reads = kind.reads ? kind.reads(option, settings, {}) : std::nullopt;
    if (reads.value_or(acts_for(option.acts_for, kind.way))) return true;
  }
  return std::any_of(listings().begin(), listings().end(),
                     [&](const NamedListing& listing) { return listing_reads(listing, option.key); });
}

/// Without a switch only what the scene has not got: no combination of settings would help.
TEST(Waking, OnlyTheSceneCanLackMore) {
  for (const BuiltinScene& builtin : scenes()) {
    const SceneTraits traits = scene_traits(load_scene(builtin.name));
    for (const auto& start : starts())
      for (const Option& option : option_table()) {
        const Waking waking = waking_of(option, settings_with({}, start), traits);
        if (waking.missing.empty() || !has_a_renderer(option)) continue;
        const bool of_scene = waking.missing.find("scene") != std::string::npos ||
                              waking.missing.find("no light casts shadows") != std::string::npos;
        EXPECT_TRUE(of_scene) << builtin.name << ' ' << fmt::format("{}", fmt::join(start, " ")) << ": " << option.key
                              << " has no switch: " << waking.missing;
      }
  }
}

TEST(IdleReason, MakesItsSentenceOfWhatIsNeeded) {
  EXPECT_EQ(needs("shadows", Shadows::map).text(), "needs shadows = map");
  EXPECT_EQ(needs("self-hit", SelfHit::epsilon, SelfHit::normal_bump).text(),
            "needs self-hit = epsilon or normal-bump");
  EXPECT_EQ(needs("multisampling", 1).because("why").text(), "needs multisampling = 1: why");
  EXPECT_EQ(needs("lighting", true).said("needs light").text(), "needs light");
  EXPECT_EQ(IdleReason("the scene has no texture").text(), "the scene has no texture");
}

/// A reason names another option of the table, and setting that answers the reason.
TEST(IdleReason, NamesSettingsThatAnswerIt) {
  int answered = 0;
  for (const BuiltinScene& builtin : scenes()) {
    const SceneTraits traits = scene_traits(load_scene(builtin.name));
    for (const auto& start : starts())
      for (const Option& option : option_table()) {
        const Settings settings = settings_with({}, start);
        const auto reason = inactive_reason(option, settings, traits);
        if (!reason) continue;
        EXPECT_EQ(reason->needs().empty(), reason->kind() != IdleReason::Kind::setting) << option.key;
        for (const Need& need : reason->needs()) {
          const Option* other = find_option(need.option);
          ASSERT_TRUE(other && other != &option) << option.key << ": " << need.option;
          Settings then = settings;
          other->set(then, need.value);
          if (other->get(settings) == need.value) continue;  // one of several, which is not enough alone
          const bool can_be_set = acts(*other, then, traits);
          EXPECT_TRUE(!can_be_set || text_of(inactive_reason(option, then, traits)) != reason->text())
              << builtin.name << ": " << option.key << " with " << need.option;
          ++answered;
        }
      }
  }
  EXPECT_GT(answered, 1000 / test::trial_divisor);
}

std::string text_of(std::string_view key, const std::vector<std::string>& settings, const std::string& scene) {
  return waking_text(waking_of(*find_option(key), settings_with({}, settings), scene_traits(load_scene(scene))));
}

TEST(Waking, AsksForWhatTheReasonNames) {
  EXPECT_EQ(text_of("shadow-epsilon", {}, "cgfs/shadows"), "needs Self-hit guard = epsilon");
  EXPECT_EQ(text_of("backface-culling", {}, "cgfs/cubes"), "needs Renderer = rasterizer");
  EXPECT_EQ(text_of("renormalise", {"renderer=rasterizer", "shading=gouraud"}, "cgfs/shading"),
            "needs Shading = Phong");
  EXPECT_EQ(text_of("specular", {"renderer=rasterizer", "draw=wireframe"}, "cgfs/crates"), "needs Draw = filled");
  EXPECT_EQ(text_of("sample-pattern", {"renderer=rasterizer"}, "cgfs/shadows"), "needs Renderer = ray tracer");
  EXPECT_EQ(text_of("adaptive-threshold", {}, "cgfs/shadows"), "needs Samples per pixel = 4, Adaptive sampling on");
  EXPECT_EQ(text_of("shadow-epsilon", {"renderer=rasterizer"}, "cgfs/shadows"),
            "needs Renderer = ray tracer, Self-hit guard = epsilon");
  EXPECT_EQ(text_of("texture-filter", {}, "cgfs/spheres"), "the scene has no texture");
  EXPECT_EQ(text_of("shading", {"renderer=rasterizer"}, "cgfs/shading"), "");
}

/// Shapes that are filled by rows have no edge functions; with others beside them in space, or with fills by edge
/// functions, there are some.
TEST(Waking, FillRuleAndSubPixelBitsRestWhileAllIsFilledByRows) {
  const SceneTraits canvas = scene_traits(load_scene("lab/polygons"));
  ASSERT_TRUE(canvas.canvas_triangles && !canvas.triangles && !canvas.spheres && !canvas.solids);
  SceneTraits with_models = canvas, lines_alone = canvas;
  with_models.triangles = true;
  lines_alone.canvas_triangles = false;
  const Settings rows = settings_with({}, {"renderer=rasterizer", "canvas-fill=rows"});
  const Settings edges = settings_with({}, {"renderer=rasterizer", "canvas-fill=edge-functions"});
  for (const char* key : {"fill-rule", "subpixel-bits"}) {
    const Option& option = *find_option(key);
    EXPECT_EQ(text_of(inactive_reason(option, rows, canvas)), "needs canvas-fill = edge-functions") << key;
    EXPECT_EQ(waking_text(waking_of(option, rows, canvas)), "needs Fill of canvas shapes = edge functions") << key;
    EXPECT_FALSE(inactive_reason(option, edges, canvas)) << key;
    EXPECT_FALSE(inactive_reason(option, rows, with_models)) << key;
    EXPECT_FALSE(inactive_reason(option, rows, lines_alone)) << key;
    EXPECT_FALSE(inactive_reason(option, rows, scene_traits(load_scene("cgfs/cubes")))) << key;
  }
}

}  // namespace
}  // namespace ps
