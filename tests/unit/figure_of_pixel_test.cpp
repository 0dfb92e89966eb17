// Figures with numbers of the picked pixel: against closed forms, where a story lacks one, and the faults of authors.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/check_figures.h"
#include "engine/figure.h"
#include "engine/lesson.h"
#include "scene/load.h"
#include "support/read_figures.h"
#include "support/render_once.h"

namespace ps::figure_of_pixel_test {
namespace {

using test::figure_fault;
using test::figure_of;
using test::marks_of;

/// A figure as the window draws it for this story.
std::shared_ptr<const Figure> drawn_for(const std::string& lines, const PixelStory& story) {
  return figure_of_pixel(std::make_shared<const Figure>(figure_of(lines)), &story);
}

PixelStory story_at(const std::string& name, const Vec2i& pixel, const Settings& settings) {
  const Scene scene = load_scene(name);
  return inspect(scene, {scene.camera, 600, 600}, settings, pixel);
}

// The red sphere has its centre at (0, -1, 3) and the radius 1, the point light is at (2, 1, 0).
TEST(FigureOfAPixel, HasTheAnglesOfItsStory) {
  Settings settings;
  settings.precision = Precision::float64;
  const Vec2i pixel(340, 430);
  const PixelStory story = story_at("cgfs/lights", pixel, settings);
  const Vec3d ray((pixel.x + 0.5 - 300) / 600, (300 - pixel.y - 0.5) / 600, 1), centre(0, -1, 3), lamp(2, 1, 0);
  const double a = dot(ray, ray), b = -2 * dot(ray, centre), c = dot(centre, centre) - 1;
  const Vec3d point = ray * ((-b - std::sqrt(b * b - 4 * a * c)) / (2 * a)), normal = point - centre;
  const Vec3d to_light = lamp - point, mirrored = 2 * dot(normal, to_light) * normal - to_light;
  const double cosine = dot(normal, to_light) / length(to_light);
  const double shine = dot(mirrored, -ray) / (length(mirrored) * length(ray));

  const auto figure = drawn_for("pixel alpha angle light 1: n-dot-l = 10\npixel c light 1: n-dot-l = 0.5\n"
                                "pixel s light 1: r-dot-v = 0.5\nplace L turn (0, 1) (0, 0) @alpha\n"
                                "arrow (0, 0) L\nline (0, 0) (@c, -@s) : @c",
                                story);
  const auto lines = marks_of<FigureLine>(*figure);
  ASSERT_EQ(lines.size(), 2u) << figure->note;
  EXPECT_NEAR(lines[0].places[1].y, cosine, 1e-5);
  EXPECT_NEAR(lines[0].places[1].x, -std::sqrt(1 - cosine * cosine), 1e-5);
  EXPECT_NEAR(lines[1].places[1].x, cosine, 1e-5);
  EXPECT_NEAR(lines[1].places[1].y, -shine, 1e-5);
  EXPECT_EQ(marks_of<FigureLabel>(*figure).front().words, fmt::format("{:.3g}", cosine));
  EXPECT_EQ(figure->note, "At pixel (340, 430).");
}

// The wall goes from z = 2 on the left to z = 10; a place on the screen is x/z (chapters/cgfs_12_hidden_surfaces).
// There 1/z is linear: 1/2 at x/z = -1/2 (column 0), 1/10 at x/z = 1/10 (column 360). A panel lies behind it.
TEST(FigureOfAPixel, HasTheFragmentThatIsSeen) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.backface_culling = false;
  const PixelStory story = story_at("chapters/cgfs_12_hidden_surfaces/segment.scene", {300, 300}, settings);
  const auto figure =
      drawn_for("pixel s share 0.5 0.1 fragment: inverse-z = 0\npixel z fragment: z = 0\nline (0, 0) (@s, @z)", story);
  const auto lines = marks_of<FigureLine>(*figure);
  ASSERT_EQ(lines.size(), 1u) << figure->note;
  EXPECT_EQ(figure->note, "At pixel (300, 300).");
  EXPECT_NEAR(lines[0].places[1].x, 300.5 / 360, 1e-5);
  EXPECT_NEAR(lines[0].places[1].y, 1 / (0.5 - 0.4 * 300.5 / 360), 1e-3);
}

TEST(FigureOfAPixel, IsTheStepsOwnWhereTheStoryLacksANumber) {
  const PixelStory sky = story_at("cgfs/lights", {5, 5}, Settings{});
  const auto own = std::make_shared<const Figure>(figure_of("pixel c light 1: n-dot-l = 0.25\nline (0, 0) (@c, 1)"));
  EXPECT_EQ(own->note, "At the step's own pixel.");
  EXPECT_EQ(figure_of_pixel(own, nullptr), own);
  const auto figure = figure_of_pixel(own, &sky);
  EXPECT_EQ(figure->note, "Pixel (5, 5) has no n dot l of light 1. So this is drawn for the step's own pixel.");
  EXPECT_EQ(figure_words(*figure), "Words. " + figure->note);
  EXPECT_EQ(marks_of<FigureLine>(*figure).at(0).places[1].x, 0.25);
  // Others are as they are.
  const auto plain = std::make_shared<const Figure>(figure_of("line (0, 0) (1, 1)"));
  EXPECT_EQ(figure_of_pixel(plain, &sky), plain);
}

TEST(FigureOfAPixel, IsTheStepsOwnWhereItsNumbersCannotBeDrawn) {
  const PixelStory story = story_at("cgfs/lights", {340, 430}, Settings{});
  const auto figure = drawn_for("pixel t hit: t = 0.5\ndepth-along-span at=@t", story);
  EXPECT_EQ(figure->note, "Pixel (340, 430) lies outside this figure. So this is drawn for the step's own pixel.");
}

TEST(FigureOfAPixel, FaultsOfNumbersOfAPixelHaveTheirPlaces) {
  EXPECT_TRUE(figure_fault("alt A.\npixel c light 1: n-dot-l = 1\nline (0, 0) (@d, 1)")
                  .starts_with("lesson.md:12:14: found '@d', expe"));
  EXPECT_TRUE(figure_fault("alt A.\npixel c light 1: n-dot-x = 1")
                  .starts_with("lesson.md:11:9: field: 'light' has no 'n-dot-x';"));
  EXPECT_TRUE(figure_fault("alt A.\npixel c light 1: n-dot-l = x")
                  .starts_with("lesson.md:11:28: found 'x', expected a number"));
  EXPECT_TRUE(figure_fault("alt A.\npixel c light 1: n-dot-l")
                  .starts_with("lesson.md:11:1: found too few words, expected pixel NAME"));
  EXPECT_TRUE(figure_fault("alt A.\npixel c angle = 1").starts_with("lesson.md:11:9: found 'angle' of nothing,"));
  EXPECT_TRUE(
      figure_fault("alt A.\npixel c share 1 1 hit: t = 1").starts_with("lesson.md:11:17: found a share of nothing,"));
  EXPECT_TRUE(figure_fault("alt A.\npixel a-b hit: t = 1").starts_with("lesson.md:11:7: found 'a-b', expected a name"));
  EXPECT_TRUE(
      figure_fault("alt A.\npixel t hit: t = 1\npixel t hit: t = 1").starts_with("lesson.md:12:7: found a second 't'"));
}

TEST(FigureOfAPixel, NumbersOfAllLessonsAreThoseOfTheStepsPixel) {
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    Progress progress;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i)
      for (const std::string& fault : figure_faults(lesson, static_cast<int>(i), progress)) ADD_FAILURE() << fault;
  }
}

TEST(FigureOfAPixel, ANumberThatIsNotThatOfTheStepsPixelIsFound) {
  const auto faults = [](const std::string& number) {
    const Lesson lesson = parse_lesson("# Title\nsource: none\n## Step\n\n```figure\nalt A.\n" + number +
                                           "\nline (0, 0) (@t, 1)\n```\n\n```settings\nscene cgfs/spheres\n"
                                           "pixel 300,400\n```\n",
                                       "wrong", "lesson.md");
    Progress progress;
    return figure_faults(lesson, 0, progress);
  };
  EXPECT_EQ(faults("pixel t hit: t = 2.22"), std::vector<std::string>{});
  EXPECT_EQ(faults("pixel t hit: t = 2.3"),
            std::vector<std::string>{"lesson.md:7:7: found 't' = 2.3, expected 2.222, as at the step's own pixel"});
  EXPECT_EQ(faults("pixel t shadow > hit: t = 2.3"),
            std::vector<std::string>{
                "lesson.md:7:7: found 't', expected a number that the step's own pixel has: no t of hit, shadow ray"});
}

}  // namespace
}  // namespace ps::figure_of_pixel_test
