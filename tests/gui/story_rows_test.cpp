// Which events of a story share a row, against runs counted by hand.
#include "gui/panels/story/story_rows.h"

#include <gtest/gtest.h>

namespace ps::gui::story_rows_test {
namespace {

Event light(int index) {
  LightEvent event;
  event.light = index;
  event.kind = LightKind::point;
  return {0, event};
}
Event node(bool entered) { return {0, NodeEvent{.entered = entered}}; }
Event test(TestOutcome outcome, int parent = 0) {
  SphereTestEvent event;
  event.id = {0, 0};
  event.outcome = outcome;
  return {parent, event};
}

std::vector<Event> ray_with(std::vector<Event> children) {
  std::vector<Event> events{{-1, RayEvent{}}};
  events.insert(events.end(), children.begin(), children.end());
  return events;
}

std::vector<StoryRow> rows_of(const std::vector<Event>& events) {
  return story_rows(events, subtree_ends(events), 1, static_cast<int>(events.size()));
}

TEST(StoryRows, BoxesShareARowAndHitsDoNot) {
  const auto events = ray_with({node(true),
                                node(true),
                                node(false),
                                test(TestOutcome::missed),
                                test(TestOutcome::accepted),
                                node(false),
                                {0, HitEvent{}}});
  const auto rows = rows_of(events);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_TRUE(rows[0].run);
  EXPECT_EQ(rows[0].first, 1);
  EXPECT_EQ(rows[0].last, 5);
  EXPECT_EQ(run_text(events, rows[0]), "3 boxes visited, 2 entered; 1 primitive missed");
  EXPECT_FALSE(rows[1].run);
  EXPECT_EQ(rows[1].first, 5);
  EXPECT_FALSE(rows[2].run) << "one box by itself has a row of its own";
  EXPECT_EQ(rows[3].first, 7);
}

TEST(StoryRows, AFewMissesStandAloneManyDoNot) {
  std::vector<Event> few(most_single_misses, test(TestOutcome::missed));
  EXPECT_EQ(rows_of(ray_with(few)).size(), few.size());
  few.push_back(test(TestOutcome::beyond_range));
  const auto events = ray_with(few);
  const auto rows = rows_of(events);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(run_text(events, rows[0]), "7 primitives missed");
}

TEST(StoryRows, EveryEventIsInExactlyOneRow) {
  const auto events = ray_with({node(true),
                                test(TestOutcome::farther),
                                node(true),
                                node(true),
                                {0, RayEvent{.kind = RayKind::shadow}},
                                {5, SphereTestEvent{}},
                                light(1),
                                {0, PixelEvent{}}});
  int next = 1;
  for (const auto& row : rows_of(events)) {
    EXPECT_EQ(row.first, next);
    next = row.last;
  }
  EXPECT_EQ(next, static_cast<int>(events.size()));
}

TEST(StoryRows, AShadowRayNamesItsLight) {
  const auto events = ray_with({{0, RayEvent{.kind = RayKind::shadow}}, test(TestOutcome::missed, 1), light(1)});
  EXPECT_EQ(row_text(events, subtree_ends(events), Scene{}, 1), "shadow ray to light 1: not blocked (1 test)");
}

TEST(StoryRows, ALightThatAddsNothingHasNoRow) {
  LightEvent lamp;
  lamp.light = 1;
  lamp.kind = LightKind::point;
  lamp.diffuse = 0.5;
  lamp.specular = 8.7e-98;
  const auto events = ray_with({{0, lamp}});
  EXPECT_EQ(row_text(events, subtree_ends(events), Scene{}, 1), "light 1: diffuse 0.5, specular adds nothing");
}

TEST(StoryRows, AStencilSaysItsCountAndTheFacesBelow) {
  StencilEvent stencil;
  stencil.light = 1;
  stencil.count = stencil.stored = 1;
  for (const int change : {1, 0, 1, -1}) {
    VolumeCrossing crossing;
    crossing.object = 0;
    crossing.change = change;
    crossing.enters = change > 0;
    crossing.part = VolumePart::lit_face;
    stencil.crossings.push_back(crossing);
  }
  const auto events = ray_with({{0, stencil}});
  EXPECT_EQ(row_text(events, subtree_ends(events), Scene{}, 1),
            "stencil of light 1: 3 of 4 shadow volume faces are counted, sum 1: in shadow");
  EXPECT_EQ(short_description(events[1], Scene{}),
            "stencil of light 1: 3 of 4 shadow volume faces are counted, sum 1: in shadow")
      << "which the space view writes over its foot";
  const auto lines = row_details(events[1], Scene{});
  ASSERT_EQ(lines.size(), 3u) << "one for each face that counts";
  EXPECT_EQ(lines[0], "+1 where the line of sight enters the shadow volume of object 0 at its lit face");
  EXPECT_EQ(lines[2], "-1 where the line of sight leaves the shadow volume of object 0 at its lit face");
  EXPECT_TRUE(row_details(events[0], Scene{}).empty());
}

}  // namespace
}  // namespace ps::gui::story_rows_test
