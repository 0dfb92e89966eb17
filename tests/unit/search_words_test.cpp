// People search with the words of other programs and books; options, experiments and scenes are found by them.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/word_search.h"
#include "options/option_search.h"
#include "scene/load.h"
#include "study/stability/experiment.h"

namespace ps::search_words_test {
namespace {

TEST(WordSearch, WantsEveryWordSomewhere) {
  EXPECT_TRUE(has_words("", {"shading"}));
  EXPECT_TRUE(has_words("  ", {}));
  EXPECT_TRUE(has_words("PHONG shad", {"Shading", "Phong"}));
  EXPECT_FALSE(has_words("phong map", {"Shading", "Phong"}));
  EXPECT_FALSE(has_words("phong", {}));
  EXPECT_TRUE(has_words("Moiré", {"moiré, aliasing"}));
}

struct Sought {
  std::string words;
  std::vector<std::string> options, experiments, scenes;  ///< keys that must be among those found
};

std::vector<std::string> found_options(const std::string& words) {
  std::vector<std::string> keys;
  for (const Option& option : option_table())
    if (option_matches(option, words)) keys.emplace_back(option.key);
  return keys;
}

std::vector<std::string> found_experiments(const std::string& words) {
  std::vector<std::string> keys;
  for (const StabilityExperiment& experiment : stability_experiments())
    if (experiment_matches(experiment, words)) keys.emplace_back(experiment.key);
  return keys;
}

std::vector<std::string> found_scenes(const std::string& words) {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes())
    if (has_words(words, {scene.name, scene.title, scene.description, scene.keywords})) names.push_back(scene.name);
  return names;
}

void expect_among(const std::vector<std::string>& wanted, const std::vector<std::string>& found,
                  const std::string& words) {
  for (const std::string& key : wanted)
    EXPECT_NE(std::find(found.begin(), found.end(), key), found.end()) << words << " does not find " << key;
}

TEST(SearchWords, FindWhatTheyMeanElsewhere) {
  const Sought all[] = {
      {"z-buffer", {"visibility", "depth-format"}, {"depth-bits-z-fighting", "painter-s-cycle"}, {"cgfs/depth"}},
      {"zbuffer", {"visibility"}, {"near-plane"}, {"lab/z-fighting"}},
      {"depth buffer", {"visibility"}, {"depth-bits-z-fighting"}, {"cgfs/depth"}},
      {"depth test", {"visibility"}, {}, {"cgfs/depth"}},
      {"hidden surface", {"visibility"}, {"painter-s-cycle"}, {"cgfs/depth"}},
      {"AA", {"samples-per-pixel", "multisampling"}, {"supersampling-rate"}, {"cgfs/fence"}},
      {"msaa", {"multisampling"}, {}, {"cgfs/fence"}},
      {"supersampling", {"samples-per-pixel"}, {"adaptive-sampling-misses"}, {"cgfs/fence"}},
      {"antialias", {"samples-per-pixel", "multisampling"}, {"grid-moire"}, {"cgfs/fence"}},
      {"anti-aliasing", {"samples-per-pixel", "multisampling"}, {}, {}},
      {"fov", {"field-of-view-span", "viewport-fit"}, {}, {}},
      {"acne", {"shadow-bias", "shadow-epsilon", "self-hit"}, {"ground-sphere-acne"}, {"lab/shadow-acne"}},
      {"bias", {"shadow-bias", "mip-bias"}, {"peter-panning"}, {"lab/shadow-acne"}},
      {"peter-panning", {"shadow-bias"}, {"peter-panning"}, {"lab/shadow-acne"}},
      {"peter panning", {"shadow-bias"}, {"peter-panning"}, {}},
      {"moire", {"sample-pattern"}, {"grid-moire"}, {"cgfs/fence"}},
      {"banding", {"colour-depth", "gamma"}, {}, {"cgpp/test-pattern"}},
      {"gamma", {"gamma"}, {"srgb-averaging"}, {"cgpp/test-pattern"}},
      {"overflow", {"edge-arithmetic", "stencil-bits"}, {"int32-edge-functions"}, {"lab/stacked-shadows"}},
      {"bilinear", {"texture-filter"}, {}, {"cgfs/crates"}},
      {"gouraud", {"shading"}, {"gouraud-highlight"}, {"cgfs/shading"}},
      {"glass", {"refraction"}, {"refraction-total-internal"}, {"cgfs/magnifying-glass"}},
      {"instancing", {}, {}, {"lab/tea-party"}},
  };
  for (const Sought& one : all) {
    expect_among(one.options, found_options(one.words), one.words);
    expect_among(one.experiments, found_experiments(one.words), one.words);
    expect_among(one.scenes, found_scenes(one.words), one.words);
  }
}

TEST(SearchWords, DoNotFindEverything) {
  for (const char* words : {"z-buffer", "fov", "acne", "gouraud", "msaa"}) {
    EXPECT_LT(found_options(words).size(), option_table().size() / 5) << words;
    EXPECT_LT(found_experiments(words).size(), stability_experiments().size() / 4) << words;
  }
  EXPECT_TRUE(found_options("kitchen sink").empty());
  EXPECT_TRUE(found_experiments("kitchen sink").empty());
}

TEST(SearchWords, AreThereForEveryRow) {
  for (const Option& option : option_table()) EXPECT_FALSE(option.keywords.empty()) << option.key;
  for (const StabilityExperiment& experiment : stability_experiments())
    EXPECT_FALSE(experiment.keywords.empty()) << experiment.key;
  for (const BuiltinScene& scene : builtin_scenes()) EXPECT_FALSE(scene.keywords.empty()) << scene.name;
}

}  // namespace
}  // namespace ps::search_words_test
