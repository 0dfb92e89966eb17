// The story of a pixel in space, against closed forms.
#include "inspect/space_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "inspect/space_parts.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::space_model_test {
namespace {

struct InspectedPixel {
  Scene scene;
  View view;
  Settings settings;
  PixelStory story;
  SpaceModel model;
};

InspectedPixel inspect_in_space(const std::string& name, Vec2i pixel, Renderer renderer, int size = 600) {
  InspectedPixel inspected;
  inspected.scene = load_scene(name);
  inspected.view = {inspected.scene.camera, size, size};
  inspected.settings.renderer = renderer;
  inspected.settings.precision = Precision::float64;
  inspected.story = inspect(inspected.scene, inspected.view, inspected.settings, pixel);
  inspected.model = build_space(inspected.scene, inspected.view, inspected.settings, &inspected.story);
  return inspected;
}

std::vector<const SpaceItem*> items_of(const SpaceModel& model, SpaceKind kind) {
  std::vector<const SpaceItem*> found;
  for (const SpaceItem& item : model.items)
    if (item.kind == kind) found.push_back(&item);
  return found;
}

double area(const std::vector<Vec3d>& p) { return glm::length(cross(p[1] - p[0], p[2] - p[0])) / 2; }

// CGFS ch. 2: on a canvas of W x W pixels the viewport of size 1 at distance 1 puts the edges of column c at
// c / W - 1/2; the camera of ch. 5 turns the frame.
TEST(SpaceModel, EyeRayPassesThroughItsPixelOnTheImage) {
  const unsigned seed = 17;
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 199);
  for (const char* name : {"cgfs/reflections", "cgfs/camera"})
    for (int i = 0; i < 20; ++i) {
      const Vec2i pixel(any(random), any(random));
      const InspectedPixel inspected = inspect_in_space(name, pixel, Renderer::ray_tracer, 200);
      const auto rays = items_of(inspected.model, SpaceKind::eye_ray);
      ASSERT_EQ(rays.size(), 1u);
      const Camera& camera = inspected.view.camera;
      const Vec3d along = rays[0]->points[1] - rays[0]->points[0];
      const Mat3d frame(camera.right, camera.up, camera.forward);  // the book's is not quite orthonormal
      const Vec3d in_camera = glm::inverse(frame) * along;
      const Vec3d at_plane = along / in_camera.z;
      const double x = in_camera.x / in_camera.z, y = in_camera.y / in_camera.z;
      EXPECT_GT(x, pixel.x / 200.0 - 0.5) << "seed " << seed;
      EXPECT_LT(x, (pixel.x + 1) / 200.0 - 0.5) << "seed " << seed;
      EXPECT_LT(y, 0.5 - pixel.y / 200.0) << "seed " << seed;
      EXPECT_GT(y, 0.5 - (pixel.y + 1) / 200.0) << "seed " << seed;
      const auto cells = items_of(inspected.model, SpaceKind::pixel_cell);
      ASSERT_EQ(cells.size(), 1u);
      Vec3d middle(0);
      for (const Vec3d& corner : cells[0]->points) middle += corner / 4.0;
      EXPECT_LT(glm::length(middle - (camera.position + at_plane)), 1e-12) << "seed " << seed;
    }
}

TEST(SpaceModel, HitsLieOnTheirRaysAndOnTheirSpheres) {
  const InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  EXPECT_EQ(count_of(inspected.model, SpaceKind::hit_point), events_of<HitEvent>(inspected.story.events).size());
  EXPECT_GE(count_of(inspected.model, SpaceKind::reflection_ray), 1);
  for (const SpaceItem* hit : items_of(inspected.model, SpaceKind::hit_point)) {
    const auto& event = event_as<HitEvent>(inspected.story.events, hit->event);
    const auto& sphere =
        std::get<Sphere>(inspected.scene.geometry->objects[static_cast<std::size_t>(event.id.object)].shape);
    EXPECT_NEAR(glm::length(hit->points[0] - sphere.centre), sphere.radius, 1e-9 * sphere.radius);
    const int ray = ray_of(inspected.story.events, hit->event);
    const auto& from = event_as<RayEvent>(inspected.story.events, ray);
    const Vec3d offset = hit->points[0] - from.origin;
    EXPECT_LT(glm::length(cross(offset, glm::normalize(from.direction))), 1e-9);
    for (const SpaceItem& item : inspected.model.items)
      if (item.event == ray && (item.kind == SpaceKind::eye_ray || item.kind == SpaceKind::reflection_ray)) {
        EXPECT_EQ(item.points[1], hit->points[0]);
      }
  }
}

TEST(SpaceModel, NormalsAreAsLongAsTheRendererHadThem) {
  const InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  const auto normals = items_of(inspected.model, SpaceKind::shading_normal);
  ASSERT_EQ(normals.size(), events_of<HitEvent>(inspected.story.events).size());
  for (const SpaceItem* arrow : normals) {
    const Vec3d drawn = arrow->points[1] - arrow->points[0];
    EXPECT_NEAR(glm::length(drawn), normal_length(inspected.model.bounds), 1e-9);
    const auto& hit = event_as<HitEvent>(inspected.story.events, arrow->event);
    EXPECT_NEAR(dot(glm::normalize(drawn), hit.shading_normal), 1, 1e-12);
  }
}

TEST(SpaceModel, ShadowRaysEndAtTheirLightOrOnTheirBlocker) {
  int blocked = 0;
  for (const Vec2i pixel : {Vec2i(300, 420), Vec2i(180, 470), Vec2i(420, 330), Vec2i(250, 480), Vec2i(100, 400)}) {
    const InspectedPixel inspected = inspect_in_space("cgfs/reflections", pixel, Renderer::ray_tracer);
    int shadow_rays = 0;
    for (const auto* ray : events_of<RayEvent>(inspected.story.events))
      shadow_rays += ray->kind == RayKind::shadow ? 1 : 0;
    EXPECT_EQ(count_of(inspected.model, SpaceKind::shadow_ray_lit) +
                  count_of(inspected.model, SpaceKind::shadow_ray_blocked),
              shadow_rays);
    int blockers = 0;
    for (const auto* light : events_of<LightEvent>(inspected.story.events)) blockers += light->blocker ? 1 : 0;
    EXPECT_EQ(count_of(inspected.model, SpaceKind::shadow_ray_blocked), blockers);
    EXPECT_EQ(count_of(inspected.model, SpaceKind::light_direction), 0);
    for (const SpaceItem* ray : items_of(inspected.model, SpaceKind::shadow_ray_blocked)) {
      double nearest = 1e30;  // distance from some sphere's surface
      for (const Object& object : inspected.scene.geometry->objects) {
        const auto& sphere = std::get<Sphere>(object.shape);
        nearest = std::min(nearest, std::abs(glm::length(ray->points[1] - sphere.centre) - sphere.radius));
      }
      EXPECT_LT(nearest, 1e-6);
      ++blocked;
    }
    for (const SpaceItem* ray : items_of(inspected.model, SpaceKind::shadow_ray_lit)) {
      const auto& event = event_as<RayEvent>(inspected.story.events, ray->event);
      if (std::isfinite(event.t_max)) {
        EXPECT_LT(glm::length(ray->points[1] - Vec3d(2, 1, 0)), 1e-2);
      }
    }
  }
  EXPECT_GT(blocked, 0);
}

TEST(SpaceModel, WithoutShadowsTheLightsAreOnlyDirections) {
  InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  inspected.settings.shadows = Shadows::none;
  inspected.settings.reflection_depth = 0;
  inspected.story = inspect(inspected.scene, inspected.view, inspected.settings, {300, 420});
  inspected.model = build_space(inspected.scene, inspected.view, inspected.settings, &inspected.story);
  EXPECT_EQ(count_of(inspected.model, SpaceKind::shadow_ray_lit), 0);
  EXPECT_EQ(count_of(inspected.model, SpaceKind::light_direction), 2);
}

TEST(SpaceModel, ThreeAreasFillTheHitTriangle) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const InspectedPixel inspected = inspect_in_space("cgfs/crates", {180, 330}, renderer);
    const auto triangles = items_of(inspected.model, SpaceKind::triangle);
    const auto parts = items_of(inspected.model, SpaceKind::barycentric_area);
    ASSERT_EQ(parts.size(), 3u);
    const SpaceItem* whole = nullptr;
    for (const SpaceItem* triangle : triangles)
      if (triangle->event == parts[0]->event) whole = triangle;
    ASSERT_TRUE(whole);
    double sum = 0;
    for (const SpaceItem* part : parts) {
      EXPECT_NEAR(area(part->points) / area(whole->points), part->weight, 1e-6);
      sum += area(part->points);
    }
    EXPECT_NEAR(sum, area(whole->points), 1e-6 * sum);
  }
}

// Fragments know their corners on the canvas only; unprojected, they are the model's own corners again, as near as the
// sub-pixel grid allows.
TEST(SpaceModel, FragmentTrianglesAreTheModelsInTheWorld) {
  const InspectedPixel inspected = inspect_in_space("cgfs/crates", {180, 330}, Renderer::rasterizer);
  int compared = 0;
  for (const SpaceItem* triangle : items_of(inspected.model, SpaceKind::triangle)) {
    const auto& fragment = event_as<FragmentEvent>(inspected.story.events, triangle->event);
    if (fragment.clipped_into > 1) continue;
    const auto world = world_triangle(inspected.scene, fragment.id);
    ASSERT_TRUE(world);
    for (const Vec3d& corner : triangle->points) {
      double nearest = 1e30;
      for (const Vec3d& true_corner : *world) nearest = std::min(nearest, glm::length(corner - true_corner));
      const double pixel_size = dot(corner - inspected.view.camera.position, inspected.view.camera.forward) / 600;
      EXPECT_LT(nearest, pixel_size / 256);
    }
    ++compared;
  }
  EXPECT_GT(compared, 0);
  EXPECT_EQ(count_of(inspected.model, SpaceKind::hit_point), events_of<FragmentEvent>(inspected.story.events).size());
}

TEST(SpaceModel, StepsAreInOrderAndEachHasSomethingToShow) {
  const InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  ASSERT_FALSE(inspected.model.steps.empty());
  for (std::size_t i = 1; i < inspected.model.steps.size(); ++i)
    EXPECT_LT(inspected.model.steps[i - 1], inspected.model.steps[i]);
  EXPECT_EQ(inspected.model.steps.front(), 0);
}

// Whatever is selected in the tree or the sum shows something: a light its shadow ray, a colour the hit it belongs to.
TEST(SpaceModel, EverySelectedEventShowsSomethingOfItsRay) {
  const InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  const auto& events = inspected.story.events;
  for (int i = 0; i + 1 < static_cast<int>(events.size()); ++i) {
    const int shown = shown_event(inspected.model, inspected.story, i);
    ASSERT_GE(shown, 0) << i;
    const EventData& data = events[static_cast<std::size_t>(i)].data;
    if (const auto* light = std::get_if<LightEvent>(&data); light && light->kind != LightKind::ambient) {
      const auto& ray = event_as<RayEvent>(events, shown);
      EXPECT_EQ(ray.kind, RayKind::shadow);
      EXPECT_EQ(ray.direction, light->to_light);
    } else if (std::holds_alternative<ShadeEvent>(data)) {
      EXPECT_EQ(ray_of(events, shown), ray_of(events, i));
      EXPECT_TRUE(std::holds_alternative<HitEvent>(events[static_cast<std::size_t>(shown)].data));
    }
  }
  EXPECT_EQ(shown_event(inspected.model, inspected.story, -1), -1);
}

TEST(SpaceModel, GroundDoesNotMakeTheSceneSmall) {
  const InspectedPixel inspected = inspect_in_space("cgfs/reflections", {300, 420}, Renderer::ray_tracer);
  EXPECT_LT(inspected.model.bounds.radius, 10);  // the ground's radius is 5000
  EXPECT_EQ(inspected.model.ground, (std::vector<bool>{false, false, false, true}));
  for (const Vec3d& seen : {Vec3d(0, 0, 0), Vec3d(0, -1, 3), Vec3d(-2, 0, 4), Vec3d(2, 0, 4)})
    EXPECT_LT(glm::length(seen - inspected.model.bounds.centre), inspected.model.bounds.radius);
}

// For a moment after another scene is opened a story is older than the scene around it.
TEST(SpaceModel, AStoryOfASceneWithMoreLightsIsSurvived) {
  const InspectedPixel inspected = inspect_in_space("cgfs/shading", {420, 330}, Renderer::rasterizer);
  ASSERT_GT(count_of(inspected.model, SpaceKind::light_direction), 1);
  Scene dark = inspected.scene;
  dark.lights = {};
  const SpaceModel model = build_space(dark, inspected.view, inspected.settings, &inspected.story);
  EXPECT_EQ(count_of(model, SpaceKind::triangle), count_of(inspected.model, SpaceKind::triangle));
  EXPECT_LT(count_of(model, SpaceKind::light_direction), count_of(inspected.model, SpaceKind::light_direction));
}

}  // namespace
}  // namespace ps::space_model_test
