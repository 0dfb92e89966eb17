// Every field of every type of event stands in every output: JSON, comma-separated values, Markdown, the table beside
// the story, and the changes since a pin.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "inspect/describe.h"
#include "inspect/parting/align_stories.h"
#include "inspect/story_changes.h"
#include "inspect/story_json.h"
#include "inspect/story_markdown.h"
#include "record/fields/fragment_fields.h"
#include "record/fields/ray_fields.h"
#include "record/fields/surface_fields.h"
#include "support/stories.h"

namespace ps::event_fields_test {
namespace {

/// One or more events of each type which together have all of its fields.
std::vector<EventData> sample_events() {
  std::vector<EventData> all;
  RayEvent ray;
  ray.inside = {{1, 1.5}};
  NodeEvent box, sphere;
  box.object = 0;
  sphere.radius = 2;
  SphereTestEvent sphere_test;
  sphere_test.roots = {{1, 2}};
  TriangleTestEvent triangle_test;
  triangle_test.rejected_by = "edge 1";
  triangle_test.weights = {{0.25, 0.25, 0.5}};
  triangle_test.t = 3;
  SolidTestEvent solid_test;
  solid_test.spans = {{0, 1, 2}};
  solid_test.crossings = {1, 2};
  TextureEvent texture;
  texture.texels = {{1, 2, 0, 0.5, {1, 0, 0}}};
  LightEvent light;
  light.kind = LightKind::point;
  light.blocker = PixelId{1, 0};
  light.visible = 0.5;
  light.ambient = 0.25;
  RejectEvent reject;
  reject.detail = "left plane";
  reject.edges = {{1, 2, 3}};
  FragmentEvent fragment;
  fragment.sphere_triangle = 4;
  fragment.edges = {{1, 2, 3}};
  fragment.tie_owned = {{true, false, false}};
  fragment.depth_stored = fragment.depth_new = 0.5;
  fragment.clipped_into = 1;
  fragment.samples = 4;
  fragment.pass = FragmentEvent::Pass::shading;
  CoverageEvent coverage;
  coverage.strategy = Coverage::scanline;
  coverage.how = "row 12";
  coverage.values = {1, 2};
  ReuseEvent reuse;
  reuse.count = 2;
  ShadowMapEvent shadow_map;
  shadow_map.cube = true;
  shadow_map.taps = {{1, 2, 3, true}};
  StencilEvent stencil;
  stencil.crossings = {VolumeCrossing{}};
  VertexLightEvent vertex_light;
  vertex_light.vertex = 1;
  PolygonEvent polygon;
  polygon.vertices = {{1, 2}, {3, 4}, {5, 6}};
  polygon.row = PolygonRowSpan{};
  ParallaxEvent parallax;
  parallax.relief = {0.5};
  return {ray,
          box,
          sphere,
          sphere_test,
          triangle_test,
          solid_test,
          HitEvent{},
          MissEvent{},
          texture,
          light,
          ShadeEvent{},
          ReflectionEvent{},
          reject,
          fragment,
          WriteEvent{},
          LineEvent{},
          PixelEvent{},
          coverage,
          RefractionEvent{},
          CutoffEvent{},
          SampleEvent{},
          CompareEvent{},
          reuse,
          NormalMapEvent{},
          shadow_map,
          stencil,
          EnvironmentEvent{},
          parallax,
          vertex_light,
          polygon};
}

PixelStory sample_story() {
  PixelStory story;
  for (EventData& data : sample_events()) story.events.push_back({-1, std::move(data)});
  return story;
}

template <class E>
void expect_all_rows(const std::map<std::string_view, std::set<std::string_view>>& seen) {
  using List = fields::List<E>;
  std::set<std::string_view> declared;
  for (const auto& row : List::rows) {
    EXPECT_TRUE(declared.insert(row.key).second) << List::kind << " has " << row.key << " twice";
    EXPECT_FALSE(row.key == "kind" || row.key == "parent" || row.key == "text") << "every event has that";
  }
  ASSERT_TRUE(seen.contains(List::kind)) << List::kind << " needs a sample";
  EXPECT_EQ(seen.at(List::kind), declared) << List::kind;
}

template <class... Events>
void expect_all_events(const std::map<std::string_view, std::set<std::string_view>>& seen,
                       const std::variant<Events...>&) {
  (expect_all_rows<Events>(seen), ...);
  EXPECT_EQ(seen.size(), sizeof...(Events)) << "each type of event has a kind of its own";
}

TEST(EventFields, SamplesHaveEveryFieldOfEveryEvent) {
  std::map<std::string_view, std::set<std::string_view>> seen;
  for (const EventData& data : sample_events())
    for (const EventField& field : event_fields(data)) seen[event_kind(data)].insert(field.key);
  expect_all_events(seen, EventData{});
}

TEST(EventFields, JsonHasEveryField) {
  const PixelStory story = sample_story();
  const auto json = nlohmann::json::parse(story_json(story, test::book_spheres(), View{}, {}));
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const auto& event = json["events"][i];
    const auto fields = event_fields(story.events[i].data);
    EXPECT_EQ(event["kind"], event_kind(story.events[i].data));
    EXPECT_EQ(event.size(), fields.size() + 3) << "and kind, parent and text";
    for (const EventField& field : fields) EXPECT_TRUE(event.contains(field.key)) << event["kind"] << ' ' << field.key;
  }
}

TEST(EventFields, CsvHasEveryField) {
  const PixelStory story = sample_story();
  const std::string csv = story_csv(story, test::book_spheres(), {});
  for (std::size_t i = 0; i < story.events.size(); ++i)
    for (const EventField& field : event_fields(story.events[i].data)) {
      const std::string start =
          "\nevent," + std::to_string(i) + ",," + std::string(event_kind(story.events[i].data)) + ",";
      const std::string name = start + std::string(field.key);
      EXPECT_TRUE(csv.find(name + ",") != std::string::npos || csv.find(name + "[0]") != std::string::npos) << name;
    }
}

TEST(EventFields, MarkdownHasEveryField) {
  const PixelStory story = sample_story();
  const Scene scene = test::book_spheres();
  std::istringstream page(story_markdown(story, scene, {scene.camera, 600, 600}, {}));
  std::vector<std::string> items;
  for (std::string line; std::getline(page, line);)
    if (line.starts_with("- **")) items.push_back(line);
  ASSERT_EQ(items.size(), story.events.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    for (const EventField& field : event_fields(story.events[i].data)) {
      const std::string name = field_label(field) + " = ";
      EXPECT_TRUE(items[i].find("**: " + name) != std::string::npos || items[i].find("; " + name) != std::string::npos)
          << event_kind(story.events[i].data) << ' ' << field.key << ": " << items[i];
    }
}

TEST(EventFields, TablesHaveEveryField) {
  const Scene scene = test::book_spheres();
  for (const Event& event : sample_story().events) {
    const auto fields = event_fields(event.data);
    const auto table = event_table(event, scene);
    ASSERT_EQ(table.size(), fields.size()) << event_kind(event.data);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      EXPECT_EQ(table[i].name, field_label(fields[i]));
      EXPECT_EQ(table[i].name.find('-'), std::string::npos) << "labels are words";
      EXPECT_FALSE(table[i].value.empty()) << table[i].name;
    }
  }
}

TEST(EventFields, PinsCompareEveryField) {
  const PixelStory story = sample_story();
  const StoryChanges changes = story_changes(story, story, test::book_spheres());
  ASSERT_EQ(changes.steps.size(), story.events.size());
  for (const StepChange& step : changes.steps) {
    ASSERT_GE(step.after, 0);
    const auto fields = event_fields(story.events[static_cast<std::size_t>(step.after)].data);
    ASSERT_EQ(step.fields.size(), fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_EQ(step.fields[i].name, field_label(fields[i]));
  }
}

TEST(EventFields, PartnersAreAboutTheSame) {
  const auto subject = [](auto event, auto change) {
    change(event);
    return event_subject(event);
  };
  const auto with_id = [](PixelId id) { return [id](auto& event) { event.id = id; }; };
  const auto as_is = [](auto&) {};
  // A primitive that another test finds is the same primitive.
  EXPECT_EQ(subject(SphereTestEvent{}, with_id({3, 0})), subject(TriangleTestEvent{}, with_id({3, 0})));
  EXPECT_EQ(subject(SphereTestEvent{}, with_id({3, 0})), subject(SolidTestEvent{}, with_id({3, 0})));
  EXPECT_NE(subject(TriangleTestEvent{}, with_id({3, 0})), subject(TriangleTestEvent{}, with_id({3, 1})));
  EXPECT_EQ(subject(FragmentEvent{}, with_id({3, 1})), subject(RejectEvent{}, with_id({3, 1})));
  EXPECT_NE(subject(FragmentEvent{}, with_id({3, 1})), subject(RejectEvent{}, with_id({2, 1})));
  EXPECT_NE(subject(FragmentEvent{}, with_id({3, 1})), subject(TriangleTestEvent{}, with_id({3, 1})));
  // A ray hits something or nothing, whatever that is.
  EXPECT_EQ(subject(HitEvent{}, with_id({3, 1})), subject(MissEvent{}, as_is));
  EXPECT_NE(subject(LightEvent{}, as_is), subject(LightEvent{}, [](auto& event) { event.light = 1; }));
  EXPECT_NE(subject(RayEvent{}, as_is), subject(RayEvent{}, [](auto& event) { event.kind = RayKind::shadow; }));
  EXPECT_NE(subject(NodeEvent{}, as_is), subject(NodeEvent{}, [](auto& event) { event.node = 1; }));
  EXPECT_NE(subject(NodeEvent{}, as_is), subject(NodeEvent{}, [](auto& event) { event.object = 1; }));
  EXPECT_EQ(subject(NodeEvent{}, as_is), subject(NodeEvent{}, [](auto& event) { event.entered = true; }));
}

}  // namespace
}  // namespace ps::event_fields_test
