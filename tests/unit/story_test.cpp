#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "inspect/describe.h"
#include "inspect/story_json.h"
#include "record/recorder.h"
#include "render/story/finish_story.h"
#include "render/story/names.h"
#include "study/stability/plain_scene.h"
#include "support/stories.h"

namespace ps::story_test {
namespace {

Vec3d sum_of_level(const std::vector<LedgerLine>& ledger, std::size_t first, std::size_t last, int level) {
  Vec3d sum{0, 0, 0};
  for (std::size_t i = first; i < last; ++i)
    if (ledger[i].level == level) sum += ledger[i].value;
  return sum;
}

/// Each line that has deeper lines after it equals their sum.
void expect_sums(const PixelStory& story) {
  const auto& ledger = story.ledger;
  EXPECT_EQ(sum_of_level(ledger, 0, ledger.size(), 0), story.linear);
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    std::size_t end = i + 1;
    while (end < ledger.size() && ledger[end].level > ledger[i].level) ++end;
    if (end > i + 1) {
      EXPECT_EQ(sum_of_level(ledger, i + 1, end, ledger[i].level + 1), ledger[i].value) << ledger[i].term;
    }
  }
}

bool has_term(const PixelStory& story, int level, const std::string& start, const Vec3d& value) {
  for (const LedgerLine& line : story.ledger)
    if (line.level == level && line.term.rfind(start, 0) == 0 && line.value == value) return true;
  return false;
}

TEST(RayStory, VerdictNamesWinnerBlockerAndBounces) {
  PixelStory story = test::mirrored_story();
  finish_story(story, test::book_spheres(), Settings{});
  EXPECT_EQ(story.verdict, "sphere 0 (red) won at t = 2.312; light 1 is blocked by sphere 2; 1 bounce");
}

// All numbers of the hand-made story are sums of powers of two, so the ledger must be exact.
TEST(RayStory, LedgerAddsUpOnEveryLevel) {
  PixelStory story = test::mirrored_story();
  finish_story(story, test::book_spheres(), Settings{});
  expect_sums(story);
  EXPECT_TRUE(has_term(story, 0, "sphere 0 (red): 0.75 x local colour", {0.328125, 0, 0}));
  EXPECT_TRUE(has_term(story, 0, "sphere 0 (red): 0.25 x reflected colour", {0, 0, 0.0625}));
  EXPECT_TRUE(has_term(story, 1, "light 0 (ambient)", {0.1875, 0, 0}));
  EXPECT_TRUE(has_term(story, 1, "light 1 (point): blocked by sphere 2", {0, 0, 0}));
  EXPECT_TRUE(has_term(story, 1, "light 2 (directional) diffuse", {0.09375, 0, 0}));
  EXPECT_TRUE(has_term(story, 1, "light 2 (directional) specular", {0.046875, 0, 0}));
  EXPECT_TRUE(has_term(story, 1, "sphere 1 (blue): local colour", {0, 0, 0.0625}));
  EXPECT_TRUE(has_term(story, 2, "light 0 (ambient)", {0, 0, 0.0625}));
}

TEST(RayStory, TermsThatDoNotAddUpBecomeOneLine) {
  PixelStory story = test::mirrored_story();
  for (Event& event : story.events)
    if (auto* light = std::get_if<LightEvent>(&event.data))
      if (light->light == 2) light->diffuse = 0.9;
  finish_story(story, test::book_spheres(), Settings{});
  expect_sums(story);
  EXPECT_FALSE(has_term(story, 1, "light 0 (ambient)", {0.1875, 0, 0}));
}

TEST(RayStory, MissReportsTheBackground) {
  PixelRecorder record(Vec2i{0, 0});
  record.begin([] { return RayEvent{}; });
  record.event([] { return SphereTestEvent{{1, 0}, TestOutcome::missed, -3, {}}; });
  record.event([] { return MissEvent{{0.5, 0.25, 1}}; });
  record.end();
  PixelStory story;
  story.events = record.take();
  story.linear = {0.5, 0.25, 1};
  finish_story(story, test::book_spheres(), Settings{});
  EXPECT_EQ(story.verdict, "the eye ray hits nothing (1 primitive was tested): background");
  expect_sums(story);
}

TEST(RayStory, DisplayLinesShowClampingAndExposure) {
  PixelStory story = test::mirrored_story();
  story.linear.x = 0.75;
  Settings settings;
  settings.exposure = 2;
  settings.gamma = 2.2;
  finish_story(story, test::book_spheres(), settings);
  EXPECT_TRUE(has_term(story, 0, "multiplied by exposure 2", {0, 0, 0}));
  EXPECT_TRUE(has_term(story, 0, "red 1.5 is clamped to 1", {0, 0, 0}));
  EXPECT_TRUE(has_term(story, 0, "to the power 1 / 2.2", {0, 0, 0}));
  EXPECT_TRUE(has_term(story, 0, "stored as 84, 0, 16", {0, 0, 0}));
}

FragmentEvent fragment(int triangle, FragmentEvent::Depth depth) {
  FragmentEvent event;
  event.id = {0, triangle};
  event.depth = depth;
  event.corner_depth = {2, 2, 2};
  return event;
}

Scene cube_scene() {
  Mesh mesh;
  mesh.name = "cube";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.resize(12);
  Scene scene = plain_scene("", std::move(mesh));
  scene.lights = Part<std::vector<Light>>({Light{LightKind::ambient, 0.5}});
  return scene;
}

PixelStory fragment_story() {
  PixelRecorder record(Vec2i{1, 1});
  record.event([] { return RejectEvent{{0, 2}, RejectReason::back_face, "", {}}; });
  record.event([] { return RejectEvent{{0, 3}, RejectReason::not_covered, "edge 1", {}}; });
  for (const int triangle : {4, 7}) {
    record.begin([&] { return fragment(triangle, FragmentEvent::Depth::passed); });
    record.event([] {
      LightEvent ambient;
      ambient.diffuse = 0.5;
      return ambient;
    });
    record.event([] { return ShadeEvent{{0, 0, 1}, {0.5, 0.5, 0.5}, {0, 0, 0}, {0, 0, 0.5}}; });
    record.event([&] { return WriteEvent{{0, triangle}, {1, 1, 1}, {0, 0, 0.5}, {0, 0, 0.5}}; });
    record.end();
  }
  record.event([] { return fragment(8, FragmentEvent::Depth::failed); });
  record.event([] { return fragment(9, FragmentEvent::Depth::failed); });
  record.event([] { return PixelEvent{{0, 0, 0.5}, {0, 0, 128}}; });
  PixelStory story;
  story.renderer = Renderer::rasterizer;
  story.pixel = {1, 1};
  story.linear = {0, 0, 0.5};
  story.display = {0, 0, 128};
  story.events = record.take();
  return story;
}

TEST(FragmentStory, VerdictCountsWhatLost) {
  PixelStory story = fragment_story();
  finish_story(story, cube_scene(), Settings{});
  EXPECT_EQ(story.verdict,
            "triangle 7 of cube 0 won; 1 earlier colour was painted over; 2 fragments failed the depth test; "
            "1 back face culled");
}

TEST(FragmentStory, LedgerShowsTheLastWriteAlone) {
  PixelStory story = fragment_story();
  finish_story(story, cube_scene(), Settings{});
  expect_sums(story);
  EXPECT_TRUE(has_term(story, 0, "triangle 7 of cube 0: colour", {0, 0, 0.5}));
  EXPECT_TRUE(has_term(story, 1, "light 0 (ambient): 0.5", {0, 0, 0.5}));
  EXPECT_FALSE(has_term(story, 0, "triangle 4 of cube 0: colour", {0, 0, 0.5}));
}

TEST(FragmentStory, AdditivePaintKeepsWhatWasThere) {
  PixelRecorder record(Vec2i{0, 0});
  record.event([] { return WriteEvent{{}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}; });
  record.event([] { return WriteEvent{{}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}; });
  PixelStory story;
  story.events = record.take();
  story.linear = {1, 1, 0};
  finish_story(story, Scene{}, Settings{});
  expect_sums(story);
  EXPECT_TRUE(has_term(story, 0, "shape on the canvas: added colour", {0, 1, 0}));
  EXPECT_EQ(story.verdict, "a shape on the canvas won; its colour is added to 1 earlier colour");
}

/// The verdict of a pixel that these shapes on the canvas wrote, one after the other.
std::string verdict_of_paints(std::initializer_list<WriteEvent> writes) {
  PixelRecorder record(Vec2i{0, 0});
  PixelStory story;
  for (const WriteEvent& write : writes) {
    record.event([&] { return write; });
    story.linear = write.after;
  }
  story.events = record.take();
  finish_story(story, Scene{}, Settings{});
  return story.verdict;
}

TEST(FragmentStory, VerdictSaysHowPaintMetWhatWasThere) {
  const Vec3d grey(0.5), red(1, 0, 0), green(0, 1, 0), yellow(1, 1, 0), black(0);
  const std::string won = "a shape on the canvas won";
  EXPECT_EQ(verdict_of_paints({{{}, grey, red, red}}), won);
  EXPECT_EQ(verdict_of_paints({{{}, grey, red, {1.5, 0.5, 0.5}}}), won + "; its colour is added to the background");
  EXPECT_EQ(verdict_of_paints({{{}, grey, red, red}, {{}, red, green, green}}),
            won + "; 1 earlier colour was painted over");
  EXPECT_EQ(verdict_of_paints({{{}, black, red, red}, {{}, red, green, yellow}, {{}, yellow, grey, {1.5, 1.5, 0.5}}}),
            won + "; its colour is added to 2 earlier colours");
  EXPECT_EQ(verdict_of_paints({{{}, black, grey, grey}, {{}, grey, red, red}, {{}, red, green, yellow}}),
            won + "; its colour is added to 1 earlier colour; 1 earlier colour was painted over");
  EXPECT_EQ(verdict_of_paints({{{}, black, yellow, yellow}, {{}, yellow, red, {1, 0, 0.0}}}),
            won + "; 1 earlier colour was painted over")
      << "a filter that looks like paint";
  EXPECT_EQ(verdict_of_paints({{{}, black, yellow, yellow}, {{}, yellow, {0.5, 1, 1}, {0.5, 1, 0}}}),
            won + "; it filters 1 earlier colour");
}

TEST(FragmentStory, NothingDrewSaysWhy) {
  PixelStory story;
  story.linear = {1, 1, 1};
  finish_story(story, cube_scene(), Settings{});
  EXPECT_EQ(story.verdict, "nothing is drawn here: background (no triangle lies close to the pixel)");
  expect_sums(story);
  story.events = {{-1, RejectEvent{{0, 1}, RejectReason::clipped_near, "", {}}}};
  finish_story(story, cube_scene(), Settings{});
  EXPECT_EQ(story.verdict, "nothing is drawn here: background (1 triangle nearer than the near plane)");
}

TEST(Describe, NamesObjectsAndKeepsAllDigits) {
  const Scene scene = test::book_spheres();
  EXPECT_EQ(object_name(scene, 1), "sphere 1 (blue)");
  EXPECT_EQ(primitive_name(scene, {2, 0}), "sphere 2");
  EXPECT_EQ(primitive_name(cube_scene(), {0, 7}), "triangle 7 of cube 0");
  EXPECT_EQ(light_name(scene, 2), "light 2 (directional)");
  const PixelStory story = test::mirrored_story();
  EXPECT_EQ(describe(story.events[2], scene), "sphere 1 (blue): missed, discriminant 0");
  EXPECT_EQ(describe(story.events[5], scene), "light 1 (point): blocked by sphere 2");
  for (const Event& event : story.events) EXPECT_FALSE(describe(event, scene).empty());
  MissEvent miss;
  miss.background = {1.0 / 3, 0, 0};
  const auto table = event_table({-1, miss}, scene);
  ASSERT_EQ(table.size(), 1u);
  EXPECT_EQ(table[0].name, "background");
  EXPECT_EQ(table[0].value, "(0.3333, 0, 0)");
  EXPECT_EQ(table[0].exact, "(0.3333333333333333, 0, 0)");
}

TEST(StoryJson, HoldsWhatTheStoryHolds) {
  PixelStory story = test::mirrored_story();
  const Scene scene = test::book_spheres();
  finish_story(story, scene, Settings{});
  const auto json = nlohmann::json::parse(story_json(story, scene, View{{}, 600, 600}, {}));
  EXPECT_EQ(json["pixel"], nlohmann::json({3, 4}));
  EXPECT_EQ(json["book-pixel"], nlohmann::json({-297, 295}));
  EXPECT_EQ(json["renderer"], "ray-tracer");
  EXPECT_EQ(json["verdict"], story.verdict);
  EXPECT_EQ(json["colour"]["display"], nlohmann::json({84, 0, 16}));
  ASSERT_EQ(json["events"].size(), story.events.size());
  EXPECT_EQ(json["events"][1]["kind"], "sphere-test");
  EXPECT_EQ(json["events"][1]["parent"], 0);
  EXPECT_EQ(json["events"][1]["roots"], nlohmann::json({2.3125, 3.5}));
  EXPECT_EQ(json["events"][1]["id"]["name"], "sphere 0 (red)");
  ASSERT_EQ(json["ledger"].size(), story.ledger.size());
  EXPECT_EQ(json["ledger"][0]["value"], nlohmann::json({0.328125, 0, 0}));
  EXPECT_EQ(json["counters"].size(), counter_count);
}

TEST(StoryJson, InfinityIsNull) {
  PixelStory story;
  RayEvent ray;
  ray.t_max = std::numeric_limits<double>::infinity();
  story.events = {{-1, ray}};
  const auto json = nlohmann::json::parse(story_json(story, Scene{}, View{}, {}));
  EXPECT_TRUE(json["events"][0]["t-max"].is_null());
}

}  // namespace
}  // namespace ps::story_test
