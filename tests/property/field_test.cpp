// A number of the story, shown for every pixel, is the number that the story of each pixel has. The oracle reads
// stories by code of its own: the events below the rays that the query names, in the fragment that wrote the pixel
// last.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "document/permalink.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "record/field_query.h"
#include "render/channel_picture.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/seeded_random.h"
#include "support/settings_with.h"

namespace ps::field_test {
namespace {

/// The kinds of the rays above an event without the eye's, and the fragment around it.
std::pair<std::vector<RayKind>, int> around(const PixelStory& story, int event) {
  std::pair<std::vector<RayKind>, int> found{{}, -1};
  while ((event = story.events[static_cast<std::size_t>(event)].parent) >= 0) {
    const EventData& data = story.events[static_cast<std::size_t>(event)].data;
    if (const auto* ray = std::get_if<RayEvent>(&data); ray && ray->kind != RayKind::eye)
      found.first.insert(found.first.begin(), ray->kind);
    if (std::holds_alternative<FragmentEvent>(data)) found.second = event;
  }
  return found;
}

const FragmentEvent* drawn_fragment(const PixelStory& story, int event) {
  if (event < 0) return nullptr;
  const auto* fragment = std::get_if<FragmentEvent>(&story.events[static_cast<std::size_t>(event)].data);
  const bool drawn =
      fragment && fragment->depth != FragmentEvent::Depth::failed && fragment->pass != FragmentEvent::Pass::depth_first;
  return drawn ? fragment : nullptr;
}

/// The number that a story has. Of fragments, that of the triangle that was drawn last, in the last pass that has it.
double number_of(const PixelStory& story, const FieldQuery& query) {
  std::optional<PixelId> seen;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i)
    if (const FragmentEvent* fragment = drawn_fragment(story, i)) seen = fragment->id;
  double number = std::nan("");
  int passed = 0, in_fragment = -1;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    const EventData& data = story.events[static_cast<std::size_t>(i)].data;
    const auto [rays, around_it] = around(story, i);
    const int own = std::holds_alternative<FragmentEvent>(data) ? i : around_it;
    const FragmentEvent* fragment = drawn_fragment(story, own);
    if (seen && (!fragment || !(fragment->id == *seen))) continue;
    if (std::exchange(in_fragment, own) != own) passed = 0;
    if (rays != query.path || !matches(query, data) || passed++ != query.order) continue;
    if (const auto found = field_number(query, data)) number = *found;
  }
  return number;
}

/// Any event, every kind that the story has as likely as another: of thousands of rejections there is no number.
int any_event(const PixelStory& story, const std::function<std::size_t(std::size_t)>& pick) {
  std::map<std::string_view, std::vector<int>> kinds;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i)
    kinds[event_kind(story.events[static_cast<std::size_t>(i)].data)].push_back(i);
  const std::vector<int>& alike = std::next(kinds.begin(), static_cast<std::ptrdiff_t>(pick(kinds.size())))->second;
  return alike[pick(alike.size())];
}

struct Case {
  const char* scene;
  std::vector<std::string> settings;
};

void expect_as_in_stories(const Case& one, std::mt19937& random) {
  const Scene scene = load_scene(one.scene);
  Settings settings = settings_with(settings_for(scene), one.settings);
  const View view{scene.camera, 48, 40};
  Prepared prepared;
  Progress progress;
  const auto pick = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  const auto any_pixel = [&] { return Vec2i(static_cast<int>(pick(48)), static_cast<int>(pick(40))); };
  int compared = 0, queries = 0;
  for (int round = 0; round < 200 && queries < 5; ++round) {
    const PixelStory chosen = inspect(scene, view, settings, any_pixel(), prepared, progress);
    const int event = any_event(chosen, pick);
    const auto fields = event_fields(chosen.events[static_cast<std::size_t>(event)].data);
    const EventField& field = fields[pick(fields.size())];
    const auto query =
        field_query(chosen.events, event, field.key, std::holds_alternative<std::vector<double>>(field.value) ? 0 : -1);
    if (!query) continue;
    ++queries;
    ASSERT_EQ(parse_field_query(field_query_text(*query)), *query) << field_query_text(*query);
    RenderRequest request;
    request.channels = Channel::field;
    request.field = std::make_shared<const ShownField>(ShownField{*query, {}});
    const Frame frame = render(scene, view, settings, request, prepared, progress);
    std::vector<Vec2i> pixels{chosen.pixel};
    for (int i = 0; i < 12; ++i) pixels.push_back(any_pixel());
    for (const Vec2i& pixel : pixels) {
      const double wanted = number_of(inspect(scene, view, settings, pixel, prepared, progress), *query);
      const float found = frame.field.at(pixel.x, pixel.y);
      const bool same = std::isnan(wanted) ? std::isnan(found) : found == static_cast<float>(wanted);
      EXPECT_TRUE(same) << one.scene << ", " << field_query_text(*query) << " at " << pixel.x << "," << pixel.y << ": "
                        << found << ", in the story " << wanted;
      compared += std::isnan(wanted) ? 0 : 1;
    }
  }
  EXPECT_GT(compared, 0) << one.scene << ": " << queries << " queries";
}

TEST(Field, IsTheNumberOfEveryPixelsStory) {
  const std::string r = "renderer=rasterizer";
  const std::vector<Case> cases{{"cgfs/reflections", {}},
                                {"cgfs/reflections", {"precision=double"}},
                                {"cgfs/reflections", {"samples-per-pixel=4"}},
                                {"cgfs/reflections", {"adaptive-sampling=on"}},
                                {"cgfs/reflections", {"shadow-cache=on"}},
                                {"cgfs/magnifying-glass", {}},
                                {"cgfs/cubes", {"shadow-any-hit=off"}},
                                {"lab/far-origin", {}},
                                {"cgfs/crates", {r}},
                                {"cgfs/shading", {r, "shading=gouraud"}},
                                {"cgfs/shading", {r, "shading=flat", "precision=double"}},
                                {"cgfs/reflections", {r, "multisampling=4"}},
                                {"cgfs/reflections", {r, "deferred-shading=on"}},
                                {"cgfs/shadows", {r, "early-depth=on", "shadows=map"}},
                                {"cgfs/shadows", {r, "shadows=stencil-depth-fail"}},
                                {"lab/z-fighting", {r, "visibility=painter"}},
                                {"cgfs/depth", {r, "visibility=draw-order"}},
                                {"cgfs/reflections", {r, "light-passes=many", "early-depth=on"}}};
  test::SeededRandom random;
  for (const Case& one : cases) expect_as_in_stories(one, random);
}

// Written by hand: in cgfs/reflections light 2 shines along (1, 4, 4), so that N.L on the ground, a sphere of radius
// 5000 whose normal is nearly (0, 1, 0), is close to 4 / sqrt(33).
TEST(Field, NDotLOnFlatGround) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 60, 60};
  Prepared prepared;
  Progress progress;
  RenderRequest request;
  request.channels = Channel::field;
  request.field = std::make_shared<const ShownField>(
      ShownField{parse_field_query("light 2: n-dot-l"), parse_field_condition("< 0")});
  const Frame frame = render(scene, view, {}, request, prepared, progress);
  EXPECT_NEAR(frame.field.at(4, 58), 4 / std::sqrt(33.0), 0.01);
  EXPECT_TRUE(std::isnan(frame.field.at(30, 2))) << "there is nothing but background";
  // The pixels that meet the condition, counted here.
  std::size_t met = 0;
  for (const float value : frame.field.pixels()) met += value < 0 ? 1 : 0;
  const ChannelPicture picture = channel_picture(frame, ShownChannel::field, {});
  ASSERT_FALSE(picture.legend.entries.empty());
  EXPECT_EQ(picture.legend.entries.back().meaning, "< 0: " + with_thousands(std::to_string(met)) + " pixels");
  EXPECT_EQ(picture.legend.title, "n dot l of light 2");
}

TEST(Field, GoesThroughAPermalink) {
  Document document = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  document.a.show = ShownChannel::field;
  document.field =
      ShownField{parse_field_query("reflection > light 1 #2: to-light.1"), parse_field_condition("> -0.5")};
  const Document again = parse_permalink(permalink(document));
  EXPECT_EQ(again.field, document.field);
  EXPECT_EQ(again.a.show, ShownChannel::field);
}

TEST(Field, RefusesWhatItCannotRead) {
  for (const char* text : {"light 1", "hit: hop", "mirror > hit: t", "reject: edges", "hit #x: t", "hit: point.7"})
    EXPECT_THROW(parse_field_query(text), InputError) << text;
  for (const char* text : {"", "about 3", "<", "< many"}) EXPECT_THROW(parse_field_condition(text), InputError) << text;
  EXPECT_TRUE(parse_field_condition("< 0.001").met_by(0));
  EXPECT_FALSE(parse_field_condition("< 0.001").met_by(0.001));
  EXPECT_FALSE(parse_field_condition("> 1").met_by(std::nan("")));
}

}  // namespace
}  // namespace ps::field_test
