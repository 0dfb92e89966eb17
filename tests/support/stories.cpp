#include "support/stories.h"

#include "record/recorder.h"

namespace ps::test {
namespace {

constexpr Vec3d red{1, 0, 0};
constexpr Vec3d blue{0, 0, 1};

Material plain(const char* name, const Vec3d& colour) {
  Material material;
  material.name = name;
  material.colour = colour;
  return material;
}

HitEvent hit(int object, double t) {
  HitEvent event;
  event.id = {object, 0};
  event.t = t;
  return event;
}

LightEvent light(int index, LightKind kind, double diffuse, double specular) {
  LightEvent event;
  event.light = index;
  event.kind = kind;
  event.diffuse = diffuse;
  event.specular = specular;
  return event;
}

RayEvent ray(RayKind kind, int depth, double share) {
  RayEvent event;
  event.kind = kind;
  event.direction = {0, 0, 1};
  event.t_min = 1;
  event.t_max = 1e30;
  event.depth = depth;
  event.share = share;
  return event;
}

SphereTestEvent sphere_test(int object, TestOutcome outcome) {
  SphereTestEvent event;
  event.id = {object, 0};
  event.outcome = outcome;
  if (outcome == TestOutcome::accepted) event.roots = {{2.3125, 3.5}};
  return event;
}

}  // namespace

Scene book_spheres() {
  Scene scene;
  scene.name = "test/spheres";
  scene.background = {0, 0, 0};
  Material mirror = plain("red", red);
  mirror.specular = 500;
  mirror.reflective = 0.25;
  scene.materials = Part<std::vector<Material>>({mirror, plain("blue", blue), Material{}});
  Geometry geometry;
  geometry.objects = {{"", Sphere{{0, -1, 3}, 1, 0}}, {"", Sphere{{2, 0, 4}, 1, 1}}, {"", Sphere{{-2, 0, 4}, 1, 2}}};
  scene.geometry = Part<Geometry>(std::move(geometry));
  Light ambient{LightKind::ambient, 0.25};
  Light point{LightKind::point, 0.5};
  point.position = {2, 1, 0};
  Light sun{LightKind::directional, 0.25};
  sun.colour = {1, 0.5, 0.5};
  sun.direction = {1, 4, 4};
  scene.lights = Part<std::vector<Light>>({ambient, point, sun});
  return scene;
}

PixelStory mirrored_story() {
  PixelRecorder record(Vec2i{3, 4});
  record.begin([] { return ray(RayKind::eye, 0, 1); });
  record.event([] { return sphere_test(0, TestOutcome::accepted); });
  record.event([] { return sphere_test(1, TestOutcome::missed); });
  record.event([] { return hit(0, 2.3125); });
  record.event([] { return light(0, LightKind::ambient, 0.25, 0); });
  record.begin([] {
    LightEvent blocked = light(1, LightKind::point, 0, 0);
    blocked.blocker = PixelId{2, 0};
    return blocked;
  });
  record.begin([] { return ray(RayKind::shadow, 0, 0); });
  record.event([] { return hit(2, 0.5); });
  record.end();
  record.end();
  record.event([] { return light(2, LightKind::directional, 0.125, 0.0625); });
  // red x (0.25 + (0.125 + 0.0625) x the light's own red, which is 1)
  record.event([] { return ShadeEvent{red, Vec3d{0.4375, 0.34375, 0.34375}, {0, 0, 0}, Vec3d{0.4375, 0, 0}}; });
  record.begin([] { return ray(RayKind::reflection, 1, 0.25); });
  record.event([] { return hit(1, 4); });
  record.event([] { return light(0, LightKind::ambient, 0.25, 0); });
  record.event([] { return ShadeEvent{blue, Vec3d{0.25, 0.25, 0.25}, {0, 0, 0}, Vec3d{0, 0, 0.25}}; });
  record.end();
  const Vec3d result{0.75 * 0.4375, 0, 0.25 * 0.25};
  record.event([&] { return ReflectionEvent{0.25, Vec3d{0.4375, 0, 0}, Vec3d{0, 0, 0.25}, result}; });
  record.end();
  record.event([&] { return PixelEvent{result, {84, 0, 16}}; });
  PixelStory story;
  story.pixel = {3, 4};
  story.linear = result;
  story.display = {84, 0, 16};
  story.events = record.take();
  return story;
}

}  // namespace ps::test
