// Instances whose transforms mirror their models, against models mirrored by hand: vertices moved to where they end up
// in the world, and corners of triangles in the opposite order.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "inspect/describe.h"
#include "render/story/story_tree.h"
#include "scene/scene_file.h"
#include "scene/world.h"
#include "support/all_accelerators.h"
#include "support/render_once.h"

namespace ps::mirrored_instance_test {
namespace {

/// A teapot with vertex normals, and a wedge without, seen from its front alone; each in one of the transforms below.
std::string scene_with(const std::string& transform, const std::string& sides) {
  return "model { name = t generator = teapot divisions = 2 color = red specular = 30 }"
         "model { name = w color = green vertices { 0 = (-1,-1,-1) 1 = (1,-1,-1) 2 = (-1,1,-1) 3 = (-1,-1,1) }"
         "  triangles { 0 = 0,2,1 1 = 0,1,3 2 = 0,3,2 3 = 1,2,3 } }"
         "rectangle { corner = (-9,-2.2,2) side_a = (0,0,12) side_b = (18,0,0) color = yellow }"
         "light { type = ambient intensity = 0.2 } light { type = point intensity = 0.6 position = (2,3,0) }"
         "light { type = directional intensity = 0.2 direction = (-1,4,-4) }" +
         ("instance { model = t " + sides + transform + "translation = (-1.2,-0.7,9) } }") + "instance { model = w " +
         sides + transform + "translation = (2,0.5,6) } }";
}

/// The same triangles with the same fronts in the world, under the identity.
Scene mirrored_by_hand(Scene scene) {
  scene.geometry.edit([](Geometry& geometry) {
    for (Object& object : geometry.objects) {
      auto* instance = std::get_if<Instance>(&object.shape);
      if (!instance) continue;
      const Transform t = std::exchange(instance->transform, Transform{});
      Mesh mesh = *geometry.meshes[instance->mesh];
      mesh.patches.clear();
      for (Vec3d& p : mesh.positions) p = t.rotation * (t.scale * p) + t.translation;
      for (Vec3d& n : mesh.normals) n = t.rotation * (n / t.scale);
      for (MeshTriangle& triangle : mesh.triangles) {
        std::swap(triangle.position[1], triangle.position[2]);
        std::swap(triangle.normal[1], triangle.normal[2]);
        std::swap(triangle.uv[1], triangle.uv[2]);
      }
      instance->mesh = static_cast<std::uint32_t>(geometry.meshes.size());
      geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    }
  });
  return scene;
}

const std::vector<std::string> mirrors_of_space{
    "transform { scale = (-1,1,1) ", "transform { scale = (1,-1,1) rotation = <40 degrees around the Y axis> ",
    "transform { scale = (-1,-1,-1) ", "transform { rotation = [(0,1,0),(1,0,0),(0,0,1)] "};

Frame picture_of(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, 48, 36}, settings, request_for(Channel::facing | Channel::ids));
}

/// Pixels that differ in colour or in the side that they show.
int differing(const Frame& a, const Frame& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const Vec3f difference = glm::abs(a.colour.at(x, y) - b.colour.at(x, y));
      const bool facing = !a.facing.empty() && std::abs(a.facing.at(x, y) - b.facing.at(x, y)) > 1e-3f;
      count += facing || std::max({difference.x, difference.y, difference.z}) > 2e-3f ? 1 : 0;
    }
  return count;
}

void expect_as_by_hand(const Settings& settings, const std::string& what) {
  for (const std::string& transform : mirrors_of_space)
    for (const std::string sides : {"", "sides = front "}) {
      const Scene scene = parse_scene(scene_with(transform, sides), "mirrored.scene", ".");
      const Frame found = picture_of(scene, settings), wanted = picture_of(mirrored_by_hand(scene), settings);
      // Corners in another order round otherwise: a pixel centre on an edge may fall to the other side.
      EXPECT_LE(differing(found, wanted), 8) << what << ", " << transform << sides;
    }
}

TEST(MirroredInstance, RaysSeeItsFrontsInEveryAccelerator) {
  for (const Accelerator accelerator : test::all_accelerators())
    for (const Simd simd : {Simd::automatic, Simd::off}) {
      Settings settings;
      settings.accelerator = accelerator;
      settings.simd = simd;
      expect_as_by_hand(settings, "accelerator " + std::to_string(static_cast<int>(accelerator)));
    }
  Settings settings;
  settings.precision = Precision::float64;
  expect_as_by_hand(settings, "double");
  settings.precision = Precision::float32;
  settings.normals = Normals::triangle;
  expect_as_by_hand(settings, "flat normals");
  settings.shadows = Shadows::none;
  expect_as_by_hand(settings, "flat normals in lanes");
  settings.samples_per_pixel = 4;
  expect_as_by_hand(settings, "four samples");
}

TEST(MirroredInstance, TheRasterizerDrawsItsFronts) {
  Settings settings{.renderer = Renderer::rasterizer};
  for (const bool culling : {true, false})
    for (const Simd simd : {Simd::automatic, Simd::off})
      for (const Shading shading : {Shading::phong, Shading::gouraud, Shading::flat}) {
        settings.backface_culling = culling;
        settings.simd = simd;
        settings.shading = shading;
        settings.shadows = Shadows::none;
        expect_as_by_hand(settings, "rasterizer");
      }
  settings = Settings();
  settings.renderer = Renderer::rasterizer;
  settings.precision = Precision::float64;
  expect_as_by_hand(settings, "double");
  settings.precision = Precision::float32;
  settings.normals = Normals::triangle;
  expect_as_by_hand(settings, "flat normals");
  for (const Shadows shadows : {Shadows::stencil_depth_fail, Shadows::stencil_depth_pass, Shadows::map}) {
    settings.shadows = shadows;
    settings.shadow_map_size = 128;
    expect_as_by_hand(settings, "shadows");
  }
}

TEST(MirroredInstance, ListingsDrawItsFronts) {
  for (const bool lighting : {true, false}) {
    Settings settings{.renderer = Renderer::textbook};
    settings.lighting = lighting;
    expect_as_by_hand(settings, "textbook");
  }
}

TEST(MirroredInstance, StandsInAGroupThatMirrors) {
  const std::string rest =
      " light { type = ambient intensity = 0.2 } light { type = point intensity = 0.6 position = (2,3,0) }";
  const std::string model = "model { name = t generator = teapot divisions = 2 color = red } ";
  const Scene group = parse_scene(
      model + "group { transform { scale = (-1,1,1) } instance { model = t position = (0.5,-0.7,9) } }" + rest,
      "group.scene", ".");
  EXPECT_TRUE(mirrors(std::get<Instance>(group.geometry->objects[0].shape).transform));
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    EXPECT_LE(differing(picture_of(group, settings), picture_of(mirrored_by_hand(group), settings)), 3);
  }
}

TEST(MirroredInstance, TheInspectorSaysThatItsFrontIsSeen) {
  const Scene scene = parse_scene(scene_with(mirrors_of_space[0], ""), "mirrored.scene", ".");
  int hits = 0;
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    const PixelStory story = inspect(scene, {scene.camera, 48, 36}, settings, {18, 19});
    const auto count = [&](const auto* seen) {
      EXPECT_FALSE(seen->back_face);
      hits += seen->id.object == 1 ? 1 : 0;
    };
    for (const auto* hit : events_of<HitEvent>(story.events)) count(hit);
    for (const auto* fragment : events_of<FragmentEvent>(story.events)) count(fragment);
  }
  EXPECT_GE(hits, 2);
}

}  // namespace
}  // namespace ps::mirrored_instance_test
