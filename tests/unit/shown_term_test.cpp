// Which line of the sum belongs to an event that is selected elsewhere, against the tree of the story.
#include "inspect/shown_term.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::shown_term_test {
namespace {

struct InspectedSum {
  PixelStory story;
  bool in_sum(int event) const {
    return std::any_of(story.ledger.begin(), story.ledger.end(),
                       [&](const LedgerLine& line) { return line.event == event; });
  }
};

InspectedSum inspect_sum(const std::string& name, Vec2i pixel, Renderer renderer) {
  const Scene scene = load_scene(name);
  Settings settings = settings_for(scene, renderer);
  return {inspect(scene, {scene.camera, 600, 600}, settings, pixel)};
}

TEST(ShownTerm, EveryEventOfATracedPixelShowsTheLineOfItsOwnRay) {
  const InspectedSum inspected = inspect_sum("cgfs/reflections", {540, 340}, Renderer::ray_tracer);
  const auto& events = inspected.story.events;
  int shadow_rays = 0, bounces = 0, hits = 0;
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const int shown = shown_term(inspected.story, i);
    if (inspected.in_sum(i)) {
      EXPECT_EQ(shown, i);
      continue;
    }
    const EventData& data = events[static_cast<std::size_t>(i)].data;
    if (shown >= 0) {
      EXPECT_TRUE(inspected.in_sum(shown)) << i;
    }
    if (const auto* ray = std::get_if<RayEvent>(&data); ray && ray->kind == RayKind::shadow) {
      ++shadow_rays;
      ASSERT_GE(shown, 0) << i;
      EXPECT_EQ(event_as<LightEvent>(events, shown).to_light, ray->direction) << "the light that it was sent to";
    } else if (ray && ray->kind == RayKind::reflection) {
      ++bounces;
      ASSERT_GE(shown, 0) << i;
      EXPECT_TRUE(std::holds_alternative<ReflectionEvent>(events[static_cast<std::size_t>(shown)].data));
      EXPECT_EQ(ray_of(events, shown), ray_of(events, i)) << "the surface that mirrors, not the one that is seen in it";
    } else if (std::holds_alternative<HitEvent>(data)) {
      ++hits;
      ASSERT_GE(shown, 0) << i;
      EXPECT_TRUE(std::holds_alternative<ShadeEvent>(events[static_cast<std::size_t>(shown)].data));
      EXPECT_EQ(ray_of(events, shown), ray_of(events, i));
    }
  }
  EXPECT_GT(shadow_rays, 1);
  EXPECT_GT(bounces, 0);
  EXPECT_GT(hits, 1);
  EXPECT_EQ(shown_term(inspected.story, -1), -1);
  EXPECT_EQ(shown_term(inspected.story, static_cast<int>(events.size())), -1);
}

TEST(ShownTerm, AFragmentShowsWhatItWroteAndOneThatLostNothing) {
  const InspectedSum inspected = inspect_sum("cgfs/depth", {108, 262}, Renderer::rasterizer);
  const auto& events = inspected.story.events;
  int won = 0, lost = 0;
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const auto* fragment = std::get_if<FragmentEvent>(&events[static_cast<std::size_t>(i)].data);
    if (!fragment) continue;
    const int shown = shown_term(inspected.story, i);
    if (fragment->depth == FragmentEvent::Depth::failed) {
      ++lost;
      EXPECT_EQ(shown, -1);
    } else {
      ++won;
      ASSERT_GE(shown, 0);
      EXPECT_EQ(event_as<WriteEvent>(events, shown).id, fragment->id);
    }
  }
  EXPECT_EQ(won, 1);
  EXPECT_EQ(lost, 1);
}

}  // namespace
}  // namespace ps::shown_term_test
