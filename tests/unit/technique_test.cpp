// One click is one comparison: its pictures differ in the technique alone, and the way back restores the document.
#include "document/technique.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/check.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/settings_with.h"
#include "support/shown_levels.h"

namespace ps::technique_test {
namespace {

Document opened(const std::string& name) { return open_document(name, load_scene(name)); }

const TechniqueChoice& choice_of(std::string_view technique, std::string_view key) {
  for (const TechniqueChoice& choice : find_technique(technique)->choices)
    if (choice.key == key) return choice;
  throw std::logic_error("no such choice");
}

Document shown(const Document& now, std::string_view technique, std::string_view key) {
  return with_technique(now, *find_technique(technique), choice_of(technique, key), load_scene);
}

/// The keys of the options that a list of assignments names.
std::set<std::string> named(const TechniqueSettings& settings) {
  std::set<std::string> keys;
  for (const auto& list : {settings.rays, settings.fragments})
    for (const std::string_view assignment : list) keys.emplace(assignment.substr(0, assignment.find('=')));
  return keys;
}

TEST(Technique, KeysAreUniqueAndScenesAreBuiltIn) {
  std::set<std::string_view> keys;
  for (const Technique& technique : technique_table()) {
    EXPECT_TRUE(keys.insert(technique.key).second) << technique.key;
    EXPECT_FALSE(technique.scenes.empty()) << technique.key;
    for (const std::string_view scene : technique.scenes)
      EXPECT_TRUE(std::any_of(builtin_scenes().begin(), builtin_scenes().end(), [&](const BuiltinScene& s) {
        return s.name == scene;
      })) << scene;
  }
}

// A viewer must see it: the pictures differ, or, where only work is saved, the triangles that are left.
TEST(Technique, EveryComparisonShowsInItsScene) {
  for (const Technique& technique : technique_table())
    for (const TechniqueChoice& choice : technique.choices) {
      if (choice.key == "gpu") continue;  // shows that two renderers agree
      SCOPED_TRACE(std::string(technique.key) + " " + std::string(choice.key));
      const Scene scene = load_scene(std::string(technique.scenes.front()));
      const auto pair = technique_pair(choice, settings_for(scene), scene_traits(scene));
      ASSERT_TRUE(pair);
      constexpr int width = 160, height = 120;
      const int differing = test::differing(test::levels_of(scene, pair->a, width, height),
                                            test::levels_of(scene, pair->b, width, height));
      if (technique.key != "culling") {
        EXPECT_GT(differing, width * height / 200);
        continue;
      }
      EXPECT_EQ(differing, 0) << "the depth buffer hides the same triangles";
      const auto drawn = [&](const Settings& settings) {
        return render(scene, {scene.camera, width, height}, settings).counters.get(Counter::triangles_drawn).value();
      };
      EXPECT_LT(drawn(pair->a) * 3, drawn(pair->b) * 2) << "of a closed model half the faces look away";
    }
}

TEST(Technique, NothingElseDiffers) {
  for (const char* start : {"cgfs/reflections", "cgfs/crates", "lab/z-fighting"})
    for (const Technique& technique : technique_table())
      for (const TechniqueChoice& choice : technique.choices) {
        SCOPED_TRACE(std::string(start) + " " + std::string(technique.key) + " " + std::string(choice.key));
        const Document document = shown(opened(start), technique.key, choice.key);
        const auto names = named(choice.b);
        const auto differing = settings_difference(document.a.settings, document.b.settings);
        EXPECT_FALSE(differing.empty());
        for (const std::string& assignment : differing)
          EXPECT_TRUE(names.count(assignment.substr(0, assignment.find('=')))) << assignment;
      }
}

TEST(Technique, IsRecognisedHoweverItCameAbout) {
  const auto techniques = technique_table();
  for (std::size_t i = 0; i < techniques.size(); ++i)
    for (std::size_t k = 0; k < techniques[i].choices.size(); ++k) {
      Document document = shown(opened("cgfs/reflections"), techniques[i].key, techniques[i].choices[k].key);
      document.before_technique.reset();
      const SceneTraits traits = scene_traits(document.scene);
      EXPECT_EQ(shown_technique(document, traits), (ShownTechnique{i, k})) << techniques[i].key;
      document.b.settings.exposure *= 2;
      EXPECT_EQ(shown_technique(document, traits), std::nullopt) << techniques[i].key;
    }
}

TEST(Technique, AtTheFirstStartRaysAreComparedWithTriangles) {
  const Document document = opened("cgfs/reflections");
  const auto on = shown_technique(document, scene_traits(document.scene));
  ASSERT_TRUE(on);
  EXPECT_EQ(technique_table()[on->technique].key, "renderer");
  EXPECT_EQ(technique_table()[on->technique].choices[on->choice].key, "triangles");
}

TEST(Technique, TheWayBackLeadsBeforeTheFirst) {
  Document before = opened("cgfs/reflections");
  before.picture_b = "mine.png";
  before.pixel = {12, 34};
  before.view.zoom = 3;
  before.a.settings.samples_per_pixel = 4;
  before.compare = CompareMode::only_a;
  const Document first = shown(before, "shadows", "off");
  EXPECT_EQ(first.picture_b, "");
  EXPECT_EQ(first.compare, CompareMode::side_by_side);
  const Document second = shown(first, "texture-filter", "nearest");
  EXPECT_EQ(second.scene_name, "cgfs/relief");
  EXPECT_TRUE(without_technique(first) == before);
  EXPECT_TRUE(without_technique(second) == before);
  EXPECT_EQ(without_technique(second).before_technique, nullptr);
}

TEST(Technique, WithoutAWayBackBBecomesA) {
  const Document document = opened("cgfs/reflections");
  const Document alone = without_technique(document);
  EXPECT_TRUE(alone.b.settings == document.a.settings);
}

TEST(Technique, WhatItNeedsIsSetInBoth) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene);
  settings.lighting = false;
  const auto pair = technique_pair(choice_of("shadows", "off"), settings, scene_traits(scene));
  ASSERT_TRUE(pair);
  EXPECT_TRUE(pair->a.lighting && pair->b.lighting);
  EXPECT_EQ(pair->a.shadows, Shadows::traced);
}

TEST(Technique, KeepsTheRendererThatKnowsIt) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings = settings_for(scene, Renderer::rasterizer);
  const auto shadows = technique_pair(choice_of("shadows", "off"), settings, scene_traits(scene));
  ASSERT_TRUE(shadows);
  EXPECT_EQ(shadows->a.renderer, Renderer::rasterizer);
  EXPECT_EQ(shadows->a.shadows, Shadows::stencil_depth_fail);
  const auto mirrors = technique_pair(choice_of("reflections", "off"), settings, scene_traits(scene));
  ASSERT_TRUE(mirrors);
  EXPECT_EQ(mirrors->b.renderer, Renderer::ray_tracer);
}

}  // namespace
}  // namespace ps::technique_test
