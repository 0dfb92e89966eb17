// What stands over the pictures: what tells them apart comes first, where no ellipsis reaches it.
#include "gui/panels/pictures/picture_text.h"

#include <gtest/gtest.h>

#include "options/option.h"
#include "scene/load.h"

namespace picture_text_test {
namespace {

using namespace ps;

std::string title_text(const Settings& settings, const SceneTraits& traits, const Settings* other = nullptr) {
  return gui::picture_title_words(settings, traits, other).text();
}

Settings with(std::initializer_list<const char*> assignments) {
  Settings settings;
  for (const char* assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}

class Title : public testing::Test {
 protected:
  SceneTraits traits = scene_traits(load_scene("cgfs/reflections"));
};

TEST_F(Title, AloneNamesTheRendererFirst) {
  EXPECT_EQ(title_text(Settings{}, traits), "ray tracer, 3 reflections");
  EXPECT_EQ(title_text(with({"renderer=rasterizer", "shadows=stencil-depth-fail"}), traits),
            "rasterizer, Phong, shadows: stencil, depth fail");
}

TEST_F(Title, OfTwoNamesFirstWhatDiffers) {
  const Settings a = with({"renderer=rasterizer", "shadows=stencil-depth-fail", "volume-caps=off"});
  const Settings b = with({"renderer=rasterizer", "shadows=stencil-depth-fail"});
  EXPECT_EQ(title_text(a, traits, &b), "without volume caps · rasterizer, Phong, shadows: stencil, depth fail");
  EXPECT_EQ(title_text(b, traits, &a), "with volume caps · rasterizer, Phong, shadows: stencil, depth fail")
      << "a default is named where the other picture has something else";
  EXPECT_EQ(title_text(a, traits, &a), title_text(a, traits));
}

TEST_F(Title, OfTwoRenderersNamesWhatIsSharedLast) {
  const Settings a = with({"exposure=2"}), b = with({"renderer=rasterizer", "exposure=2"});
  EXPECT_EQ(title_text(a, traits, &b), "ray tracer, 3 reflections · exposure 2");
  EXPECT_EQ(title_text(b, traits, &a), "rasterizer, Phong · exposure 2");
}

TEST_F(Title, ShowsNumbersWithFourDigitsUnlessTheseAreTheSame) {
  const Settings third = with({"exposure=0.33333333333333331"}), other = with({"exposure=0.33333333333333337"});
  EXPECT_EQ(title_text(third, traits), "ray tracer, 3 reflections, exposure 0.3333");
  const Settings near = with({"exposure=0.33334"});
  EXPECT_EQ(title_text(near, traits, &third), "exposure 0.33334 · ray tracer, 3 reflections");
  ASSERT_NE(third, other);
  EXPECT_NE(title_text(third, traits, &other), title_text(other, traits, &third));
}

TEST_F(Title, NoReflectionsIsADifference) {
  const Settings a, b = with({"reflection-depth=0"});
  EXPECT_EQ(title_text(a, traits, &b), "3 reflections · ray tracer");
  EXPECT_EQ(title_text(b, traits, &a), "without reflections · ray tracer");
}

TEST_F(Title, SpeaksOfWhatAPictureIsWithout) {
  const Settings a = with({"exposure=2"}), b = with({"shadows=none", "specular=off"});
  EXPECT_EQ(title_text(b, traits), "ray tracer, 3 reflections, without highlights, without shadows");
  EXPECT_EQ(title_text(b, traits, &a), "without highlights, without shadows, exposure 1 · ray tracer, 3 reflections");
  EXPECT_EQ(gui::picture_title_words(b, traits, &a).brief, "without highlights, without shadows, 1");
}

// The name of a bug would help to find it, and would not fit a small window.
TEST_F(Title, OfAListingWithAPlantedBugIsShort) {
  const Settings a = with({"renderer=textbook", "listing=cgfs-06-lines", "listing-bug=missing-lines"});
  const Settings b = with({"renderer=textbook", "listing=cgfs-06-lines"});
  EXPECT_EQ(title_text(a, traits, &b), "one changed line");
  EXPECT_EQ(title_text(b, traits, &a), "the listing");
}

}  // namespace
}  // namespace picture_text_test
