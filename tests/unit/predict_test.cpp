// Predict, then reveal: what an answer is worth.
#include "inspect/predict.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "engine/lesson.h"
#include "inspect/vertex_chain.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::predict_test {
namespace {

PixelStory story_of(const Scene& scene, Renderer renderer, Vec2i pixel) {
  Settings settings = settings_for(scene, renderer);
  return inspect(scene, {scene.camera, 600, 600}, settings, pixel);
}

TEST(Predict, ColoursAreJudgedByTheirWorstChannel) {
  const Scene scene = load_scene("cgfs/spheres");
  const PixelStory story = story_of(scene, Renderer::ray_tracer, {300, 400});  // plain red
  ASSERT_EQ(story.display, (std::array<int, 3>{255, 0, 0}));
  EXPECT_EQ(judge(Question::colour, {.colour = {255, 0, 0}}, story, scene).points, 1);
  EXPECT_EQ(judge(Question::colour, {.colour = {252, 4, 0}}, story, scene).points, 1);
  const double near = judge(Question::colour, {.colour = {225, 0, 0}}, story, scene).points;
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 1);
  EXPECT_EQ(judge(Question::colour, {.colour = {0, 255, 0}}, story, scene).points, 0);
}

TEST(Predict, WinnersAreThoseOfBothRenderers) {
  const Scene scene = load_scene("cgfs/reflections");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const PixelStory red = story_of(scene, renderer, {300, 420});
    EXPECT_EQ(winner_of(red), 0);
    EXPECT_EQ(judge(Question::winner, {.object = 0}, red, scene).points, 1);
    EXPECT_EQ(judge(Question::winner, {.object = 1}, red, scene).points, 0);
    const PixelStory sky = story_of(scene, renderer, {300, 5});
    EXPECT_EQ(winner_of(sky), -1);
    EXPECT_EQ(judge(Question::winner, {}, sky, scene).points, 1);
  }
}

/// cgfs/spheres has no lights to ask and no mirrors: one ray for each pixel.
TEST(Predict, RaysAreCounted) {
  const Scene scene = load_scene("cgfs/spheres");
  const PixelStory story = story_of(scene, Renderer::ray_tracer, {300, 400});
  EXPECT_EQ(rays_of(story), 1);
  EXPECT_EQ(judge(Question::rays, {.rays = 1}, story, scene).points, 1);
  EXPECT_EQ(judge(Question::rays, {.rays = 2}, story, scene).points, 0.5);
  EXPECT_EQ(judge(Question::rays, {.rays = 5}, story, scene).points, 0);
  EXPECT_FALSE(not_askable(Question::rays, story));
  EXPECT_TRUE(not_askable(Question::rays, story_of(scene, Renderer::rasterizer, {300, 400})));
}

/// The blades are one object: only their triangles can be distinguished.
TEST(Predict, TrianglesAreDistinguished) {
  const Scene scene = load_scene("cgfs/depth");
  const std::vector<PixelId> ids = askable_triangles(scene);
  ASSERT_EQ(ids.size(), 5u);
  const PixelStory story = story_of(scene, Renderer::rasterizer, {222, 263});
  const PixelId shown = shown_triangle(story);
  int right = 0;
  for (const PixelId& id : ids) {
    const Judgement judged = judge(Question::triangle, {.object = id.object, .triangle = id.triangle}, story, scene);
    EXPECT_EQ(judged.points, id == shown ? 1 : 0) << judged.sentence;
    right += judged.points > 0 ? 1 : 0;
  }
  EXPECT_EQ(right, 1);
  EXPECT_TRUE(askable_triangles(load_scene("models/dice")).empty());
}

TEST(Predict, LessonsAskQuestions) {
  const std::string start = "# T\nsource: S\n\n## Step\n\nText.\n\n```settings\nscene cgfs/spheres\n```\n\n";
  const Lesson lesson =
      parse_lesson(start + "```question\nask winner\ntext Which sphere is it?\n```\n", "t", "t/lesson.md");
  ASSERT_TRUE(lesson.steps.at(0).question);
  EXPECT_EQ(lesson.steps[0].question->about, Question::winner);
  EXPECT_EQ(lesson.steps[0].question->text, "Which sphere is it?");
  EXPECT_FALSE(parse_lesson(start, "t", "t/lesson.md").steps[0].question);
  for (const char* bad : {"```question\nask size\ntext What?\n```\n", "```question\nask colour\n```\n",
                          "```question\ntext What?\n```\n", "```question\nask colour\ntext What?\nhint x\n```\n"})
    EXPECT_THROW(parse_lesson(start + bad, "t", "t/lesson.md"), InputError) << bad;
}

}  // namespace
}  // namespace ps::predict_test
