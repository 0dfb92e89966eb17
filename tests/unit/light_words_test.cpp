// What is said of a light at a point, in the story as in the sum, against what the equation of light gives there.
#include "render/story/light_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inspect/describe.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/stories.h"

namespace ps::light_words_test {
namespace {

LightEvent lamp(double diffuse, double specular) {
  LightEvent event;
  event.light = 1;
  event.kind = LightKind::point;
  event.diffuse = diffuse;
  event.specular = specular;
  return event;
}

std::string brief(const LightEvent& event) { return light_effect_text(test::book_spheres(), event, LightWords::brief); }

TEST(LightWords, NumbersThatAddNothingAreNotSaid) {
  EXPECT_EQ(brief(lamp(0.5, 0.25)), "diffuse 0.5, specular 0.25");
  EXPECT_EQ(brief(lamp(0.5, 8.7e-98)), "diffuse 0.5, specular adds nothing");
  EXPECT_EQ(brief(lamp(0.5, 0)), "diffuse 0.5") << "nothing shines there, which needs no word";
  EXPECT_EQ(brief(lamp(1e-20, 0.25)), "diffuse adds nothing, specular 0.25");
  EXPECT_EQ(brief(lamp(0.5, 1.8e-4)), "diffuse 0.5, specular 0.00018") << "little, but not nothing";
  EXPECT_EQ(brief(lamp(0.5, std::nan(""))), "diffuse 0.5, specular NaN");
}

// The bound that is documented: what is below it leaves a sum of 2e-6 in float as it is.
TEST(LightWords, NothingIsNothingInFloat) {
  const float sum = 2e-6f;
  float largest = 1;
  while (!adds_nothing(largest)) largest /= 2;
  EXPECT_EQ(sum + largest, sum);
  EXPECT_FALSE(adds_nothing(1e-8));
}

TEST(LightWords, ReasonsAreTrue) {
  LightEvent away = lamp(0, 0);
  away.below_horizon = true;
  EXPECT_EQ(brief(away), "surface faces away");
  LightEvent ambient = away;
  ambient.ambient = 0.4;
  EXPECT_EQ(light_effect_text(test::book_spheres(), ambient, LightWords::whole), "surface faces away, ambient 0.4")
      << "not that it adds nothing";
  away.specular = 0.25;  // the book's highlight does not ask which way the surface faces
  EXPECT_EQ(brief(away), "surface faces away, no diffuse, specular 0.25");
  EXPECT_EQ(brief(lamp(0, 0)), "adds no light") << "it faces the lamp and sees it";
  LightEvent hidden = lamp(0, 0);
  hidden.visible = 0;
  EXPECT_EQ(brief(hidden), "in shadow");
  hidden.blocker = PixelId{2, 0};
  EXPECT_EQ(brief(hidden), "blocked by sphere 2");
}

// CGFS ch. 3: at the front of the red sphere the lamp's mirrored light passes the eye by far, and with an exponent of
// 500 the highlight is 1e-97, a number that double still has.
TEST(LightWords, StoryAndSumAgreeOnWhatAddsNothing) {
  const Scene scene = load_scene("cgfs/lights");
  const View view{scene.camera, 600, 600};
  Settings settings;
  settings.shadows = Shadows::none;
  settings.precision = Precision::float64;
  const PixelStory story = inspect(scene, view, settings, {300, 400});
  const auto lit = std::find_if(story.events.begin(), story.events.end(), [](const Event& event) {
    const auto* light = std::get_if<LightEvent>(&event.data);
    return light && light->light == 1;
  });
  ASSERT_NE(lit, story.events.end());
  const auto& light = std::get<LightEvent>(lit->data);
  ASSERT_GT(light.specular, 0) << "or there is nothing to leave out";
  EXPECT_LT(light.specular, 1e-30);
  const std::string text = describe(*lit, scene);
  EXPECT_NE(text.find("specular adds nothing"), std::string::npos) << text;
  EXPECT_EQ(text.find("e-"), std::string::npos) << text;
  for (const LedgerLine& line : story.ledger) EXPECT_EQ(line.term.find("specular"), std::string::npos) << line.term;

  // A lamp that is switched off faces the surface all the same.
  settings.light_shown = 2;
  const PixelStory sun = inspect(scene, view, settings, {300, 400});
  const auto of_lamp = std::find_if(sun.ledger.begin(), sun.ledger.end(),
                                    [](const LedgerLine& line) { return line.term.rfind("light 1", 0) == 0; });
  ASSERT_NE(of_lamp, sun.ledger.end());
  EXPECT_EQ(of_lamp->term, "light 1 (point): adds no light");
}

}  // namespace
}  // namespace ps::light_words_test
