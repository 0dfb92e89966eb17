// What a pin shows: each number of a pixel before and after a change.
#include "inspect/story_changes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"

namespace ps::story_changes_test {
namespace {

struct Pinned {
  Scene scene = load_scene("cgfs/reflections");
  View view{scene.camera, 200, 200};
  Prepared prepared;
  Progress progress;
  Vec2i pixel{100, 120};
  PixelStory inspect_with(const Settings& settings) {
    return inspect(scene, view, settings, pixel, prepared, progress);
  }
};

TEST(StoryChanges, NothingChangesByItself) {
  Pinned pinned;
  const PixelStory story = pinned.inspect_with({});
  const StoryChanges changes = story_changes(story, story, pinned.scene);
  EXPECT_EQ(changes.changed_steps, 0);
  EXPECT_EQ(changes.steps.size(), story.events.size());
  ASSERT_EQ(changes.ledger.size(), story.ledger.size());
  for (std::size_t i = 0; i < changes.ledger.size(); ++i) {
    EXPECT_FALSE(changes.ledger[i].changed());
    EXPECT_EQ(changes.ledger[i].term, story.ledger[i].term);
    EXPECT_EQ(changes.ledger[i].after, story.ledger[i].value);
  }
}

// A highlight that is switched off takes the specular terms out of the sum and leaves the diffuse ones as they were.
TEST(StoryChanges, SpecularTermsGoWithTheOption) {
  Pinned pinned;
  pinned.pixel = {122, 154};  // in the red sphere's highlight
  Settings plain;
  plain.reflection_depth = 0;
  Settings dull = plain;
  dull.specular = false;
  const PixelStory before = pinned.inspect_with(plain), after = pinned.inspect_with(dull);
  const StoryChanges changes = story_changes(before, after, pinned.scene);
  int gone = 0, kept = 0;
  for (const LedgerChange& line : changes.ledger) {
    const bool specular = line.term.find(" specular:") != std::string::npos;
    if (specular) {
      EXPECT_TRUE(line.before && !line.after) << line.term;
      ++gone;
    } else if (line.term.find(" diffuse:") != std::string::npos) {
      EXPECT_FALSE(line.changed()) << line.term;
      ++kept;
    }
  }
  EXPECT_GT(gone, 0);
  EXPECT_GT(kept, 0);
  EXPECT_EQ(changes.linear_before, before.linear);
  EXPECT_EQ(changes.linear_after, after.linear);
}

// Every line of both sums is listed once, and both columns add up.
TEST(StoryChanges, BothSumsAreListedInFull) {
  Pinned pinned;
  pinned.pixel = {151, 191};  // mirrors the ground
  Settings other;
  other.reflection_depth = 1;
  other.shadows = Shadows::none;
  const PixelStory before = pinned.inspect_with({}), after = pinned.inspect_with(other);
  const StoryChanges changes = story_changes(before, after, pinned.scene);
  Vec3d old_sum(0), new_sum(0);
  std::size_t old_lines = 0, new_lines = 0;
  for (const LedgerChange& line : changes.ledger) {
    old_lines += line.before ? 1 : 0;
    new_lines += line.after ? 1 : 0;
    if (line.level == 0 && line.before) old_sum += *line.before;
    if (line.level == 0 && line.after) new_sum += *line.after;
  }
  EXPECT_EQ(old_lines, before.ledger.size());
  EXPECT_EQ(new_lines, after.ledger.size());
  EXPECT_EQ(old_sum, before.linear);
  EXPECT_EQ(new_sum, after.linear);
  int old_steps = 0, new_steps = 0;
  for (const StepChange& step : changes.steps) {
    old_steps += step.before >= 0 ? 1 : 0;
    new_steps += step.after >= 0 ? 1 : 0;
  }
  EXPECT_EQ(old_steps, static_cast<int>(before.events.size()));
  EXPECT_EQ(new_steps, static_cast<int>(after.events.size()));
  EXPECT_GT(changes.changed_steps, 0);
}

// A sheet lets another share of the light through, and its line begins with another number: it is still the same line.
TEST(StoryChanges, ALineThatBeginsWithANumberKeepsItsPartner) {
  const auto story_of = [](const char* transparency) {
    const Scene scene = parse_scene(
        std::string("background = white\ntriangle { vertices = [(-9, -9, 5), (0, 30, 5), (9, -9, 5)]  color "
                    "= blue  transparency = ") +
            transparency + " }\nsettings { renderer = rasterizer  lighting = off  blending = sorted }\n",
        "sheet.scene", ".");
    Prepared prepared;
    Progress progress;
    return std::pair{scene, inspect(scene, {scene.camera, 20, 20}, settings_for(scene), {10, 10}, prepared, progress)};
  };
  const auto [scene, before] = story_of("0.75");
  const PixelStory after = story_of("0.25").second;
  const StoryChanges changes = story_changes(before, after, scene);
  const auto line = std::find_if(changes.ledger.begin(), changes.ledger.end(), [](const LedgerChange& change) {
    return change.term.find("x what was there") != std::string::npos;
  });
  ASSERT_NE(line, changes.ledger.end());
  ASSERT_TRUE(line->before && line->after) << line->term;
  EXPECT_EQ(*line->before, Vec3d(0.75));
  EXPECT_EQ(*line->after, Vec3d(0.25));
}

}  // namespace
}  // namespace ps::story_changes_test
