// What a scene needs, in words.
#include "study/needs_words.h"

#include <gtest/gtest.h>

#include "scene/load.h"

namespace ps::needs_words_test {
namespace {

/// Shares as a search would find them: errors of the features that are used, in their order; below 0: the scene lacks
/// it, above 1: it is off.
Needs needs_of(const std::vector<double>& errors) {
  Needs needs;
  needs.tolerance = 0.05;
  for (std::size_t i = 0; i < features().size(); ++i) {
    FeatureShare share;
    share.feature = features()[i];
    share.used = errors[i] >= 0 && errors[i] <= 1;
    share.absent = errors[i] < 0;
    share.increase = errors[i];
    needs.shares.push_back(share);
  }
  return needs;
}

TEST(NeedsWords, SayWhatIsNeededWhatIsNotAndWhatIsNotThere) {
  EXPECT_EQ(needs_sentence("cgfs/crates", needs_of({0.7, 0.2, 0.3, -1, -1, 0.06, 0.9, 0.0004})),
            "The scene 'Crates' needs lighting, shadows, highlights, attenuation and textures. It can do without "
            "vertex normals; it "
            "has nothing to reflect or refract.");
  EXPECT_EQ(needs_sentence("box", needs_of({0.7, -1, -1, -1, -1, -1, -1, -1})),
            "The scene 'Box' needs lighting. It has nothing to reflect or refract, no shadows, no highlights, no "
            "attenuated light, no "
            "textures and no vertex normals.");
  EXPECT_EQ(needs_sentence("a/b-c.scene", needs_of({0.01, 2, 2, 0.02, 2, 2, 2, 2})),
            "The scene 'B c' needs none of its features. It can do without lighting and reflected rays. With these "
            "settings unused: "
            "shadows, highlights, refraction, attenuation, textures and vertex normals.");
}

TEST(NeedsWords, NothingIsSaidBeforeEveryFeatureWasTried) {
  Needs needs = needs_of({0.7, 0.2, 0.3, -1, -1, -1, 0.9, 0});
  needs.shares.pop_back();
  EXPECT_EQ(needs_sentence("cgfs/crates", needs), "");
}

// Those with one reason stand together: a line for each would be a wall.
TEST(NeedsWords, WhatIsNotInUseIsOneSentence) {
  Needs needs = needs_of({0.7, -1, -1, -1, -1, -1, -1, -1});
  EXPECT_EQ(unused_sentence(std::span(needs.shares).first(1)), "");
  for (FeatureShare& share : needs.shares)
    if (!share.used) share.reason = "the scene has no texture";
  needs.shares[1].reason = ps::needs("lighting", true);
  const std::string sentence = unused_sentence(std::span(needs.shares).first(4));
  EXPECT_EQ(sentence,
            "Not in use: shadows (needs lighting = on); highlights and reflected rays (the scene has no texture).");
  for (FeatureShare& share : needs.shares) share.reason = "only the ray tracer uses it";
  needs.shares[4].reason = "no object is transparent";
  needs.shares[5].reason = "only the rasterizer uses it";
  EXPECT_EQ(unused_sentence(std::span(needs.shares).first(6)),
            "Not in use: shadows, highlights and reflected rays (only the ray tracer uses them); refraction (no object "
            "is transparent); attenuation (only the rasterizer uses it).");
}

TEST(NeedsWords, AToleranceHasAWord) {
  EXPECT_EQ(tolerance_words(0), "no difference");
  EXPECT_EQ(tolerance_words(0.05), "hard to see");
  EXPECT_EQ(tolerance_words(0.15), "visible");
  EXPECT_EQ(tolerance_words(0.3), "obvious");
}

TEST(NeedsWords, WhatASceneNeverUsesDoesNotDependOnSettings) {
  const SceneTraits crates = scene_traits(load_scene("cgfs/crates"));
  for (const Feature& feature : features())
    EXPECT_EQ(never_used(feature, crates),
              feature.name == "reflection" || feature.name == "refraction" || feature.name == "attenuation")
        << feature.name;
}

}  // namespace
}  // namespace ps::needs_words_test
