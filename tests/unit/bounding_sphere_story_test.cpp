// Nodes of the tree of bounding spheres are reported, described and drawn as spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "inspect/describe.h"
#include "inspect/space_model.h"
#include "raytrace/base/accelerators.h"
#include "record/event_fields.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::bounding_sphere_story_test {
namespace {

PixelStory story_with(const Scene& scene, const Settings& settings) {
  return inspect(scene, {scene.camera, 60, 60}, settings, {30, 35});
}

bool has_field(const std::vector<EventField>& fields, std::string_view key) {
  return std::any_of(fields.begin(), fields.end(), [&](const EventField& field) { return field.key == key; });
}

TEST(BoundingSphereStory, NodesAreTheSpheresOfTheTree) {
  const Scene scene = load_scene("cgfs/spheres");
  const Settings settings{.accelerator = Accelerator::bounding_spheres};
  Prepared prepared;
  const auto geometry = traced_geometry<float>(scene, settings, prepared);
  const auto accelerator = traced_accelerator<float>(scene, geometry, settings, prepared);
  const auto* tree = accelerator_as<BoundingSpheres>(accelerator);
  int nodes = 0;
  for (const Event& event : story_with(scene, settings).events)
    if (const auto* node = std::get_if<NodeEvent>(&event.data)) {
      ++nodes;
      const SphereNode& sphere = tree->nodes[static_cast<std::size_t>(node->node)];
      EXPECT_EQ(node->radius, sphere.radius);
      const Vec3d off = (node->low + node->high) * 0.5 - sphere.centre;
      EXPECT_LT(std::sqrt(dot(off, off)), 1e-9 * sphere.radius);
      EXPECT_TRUE(describe(event, scene).starts_with("sphere ")) << describe(event, scene);
      EXPECT_TRUE(has_field(event_fields(event.data), "radius"));
      EXPECT_TRUE(has_field(event_fields(event.data), "center"));
      EXPECT_FALSE(has_field(event_fields(event.data), "low"));
    }
  EXPECT_GE(nodes, 3);
}

TEST(BoundingSphereStory, SpaceDrawsGreatCircles) {
  const Scene scene = load_scene("cgfs/spheres");
  const Settings settings{.accelerator = Accelerator::bounding_spheres};
  const PixelStory story = story_with(scene, settings);
  const SpaceModel model = build_space(scene, {scene.camera, 60, 60}, settings, &story);
  int drawn = 0;
  for (const SpaceItem& item : model.items) {
    if (item.kind != SpaceKind::node) continue;
    ++drawn;
    const auto& node = std::get<NodeEvent>(story.events[static_cast<std::size_t>(item.event)].data);
    EXPECT_EQ(item.shape, SpaceShape::line);
    for (const Vec3d& point : item.points) {
      const Vec3d away = point - (node.low + node.high) * 0.5;
      EXPECT_NEAR(std::sqrt(dot(away, away)) / node.radius, 1, 1e-9);
    }
  }
  EXPECT_GE(drawn, 3);
}

TEST(BoundingSphereStory, OtherNodesStayBoxes) {
  const Scene scene = load_scene("cgfs/cubes");
  for (const Event& event : story_with(scene, Settings{.accelerator = Accelerator::octree}).events)
    if (const auto* node = std::get_if<NodeEvent>(&event.data)) {
      EXPECT_EQ(node->radius, 0);
      EXPECT_TRUE(describe(event, scene).starts_with("box "));
      EXPECT_TRUE(has_field(event_fields(event.data), "low"));
    }
}

}  // namespace
}  // namespace ps::bounding_sphere_story_test
