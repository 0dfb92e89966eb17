// Mapped normals on a stretched wall: in axes upright in the world, and by the inverse transpose of the model's matrix
// (OCT), both against what follows for a plane.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include <glm/matrix.hpp>

#include "scene/rotation.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::mapped_normals_test {
namespace {

/// A wall in the plane z = 0 of its model, u along x, v down; its map holds one normal, `texel` from 0 to 1.
Scene wall(const Vec3f& texel, const Transform& transform) {
  Scene scene = parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                            "texture { name = map  generator = checker  size = 1 }\n"
                            "material { name = clay  color = white  normal_map = map }\n"
                            "model { name = wall  materials = [clay]\n"
                            "  vertices { 0 = (-9, -9, 0)  1 = (-9, 9, 0)  2 = (9, 9, 0)  3 = (9, -9, 0) }\n"
                            "  triangles {\n"
                            "    0 = { vertices = [0, 1, 2]  uvs = [(0, 1), (0, 0), (1, 0)] }\n"
                            "    1 = { vertices = [0, 2, 3]  uvs = [(0, 1), (1, 0), (1, 1)] }\n"
                            "  }\n}\ninstance { model = wall }\n"
                            "light { type = point  intensity = 1  position = (0, 0, 0) }\n",
                            "wall.scene", ".");
  std::vector<Texture> textures = *scene.textures;
  textures[0].texels = std::make_shared<const Image<Vec3f>>(Image<Vec3f>(1, 1, texel));
  scene.textures = Part<std::vector<Texture>>(std::move(textures));
  scene.geometry.edit([&](Geometry& geometry) { std::get<Instance>(geometry.objects[0].shape).transform = transform; });
  return scene;
}

Vec3d normal_in_picture(const Scene& scene, Renderer renderer, MappedNormals how, Precision precision) {
  Settings settings{.renderer = renderer};
  settings.precision = precision;
  settings.mapped_normals = how;
  settings.backface_culling = false;
  settings.shadows = Shadows::none;
  return Vec3d(render(scene, {scene.camera, 3, 3}, settings, request_for(Channel::normal)).normal.at(1, 1));
}

Vec3d unit(const Vec3d& v) { return v / std::sqrt(dot(v, v)); }

// The wall's own normal is -z, as its vertices run clockwise seen from the eye: (b - a) x (c - a). The map tilts it by
// (0, 0.6, 0.8): up by 36.87 degrees. Stretched to three times its height the relief has a third of that slope.
TEST(MappedNormals, StretchedWallAgainstTheClosedForm) {
  Transform transform;
  transform.translation = {0, 0, 5};
  transform.scale = {1, 3, 1};
  const Scene scene = wall({0.5f, 0.8f, 0.9f}, transform);
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer})
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const Vec3d upright = normal_in_picture(scene, renderer, MappedNormals::world_frame, precision);
      const Vec3d stretched = normal_in_picture(scene, renderer, MappedNormals::inverse_transpose, precision);
      const double front = upright.z < 0 ? -1 : 1;
      const Vec3d kept{0, 0.6, 0.8 * front}, expected = unit({0, 0.2, 0.8 * front});
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(upright[axis], kept[axis], 1e-6) << axis;
        EXPECT_NEAR(stretched[axis], expected[axis], 1e-6) << axis;
      }
    }
}

// The same wall in a light from the right and from below: by Lambert's law 0.8 * 0.5863 - 0.6 * 0.3084 = 0.284 of the
// light arrives where axes stay upright, and 0.494 where the relief is stretched.
TEST(MappedNormals, StretchedWallInTheLight) {
  Transform transform;
  transform.translation = {0, 0, 5};
  transform.scale = {1, 3, 1};
  Scene scene = wall({0.5f, 0.8f, 0.9f}, transform);
  scene.lights.edit([](std::vector<Light>& lights) {
    lights[0].kind = LightKind::directional;
    lights[0].direction = {0.7491, -0.3084, -0.5863};
  });
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    settings.backface_culling = false;
    settings.shadows = Shadows::none;
    const auto brightness = [&](MappedNormals how) {
      settings.mapped_normals = how;
      return render(scene, {scene.camera, 3, 3}, settings, request_for(Channel::none)).colour.at(1, 1).x;
    };
    EXPECT_NEAR(brightness(MappedNormals::world_frame), 0.284, 5e-4);
    EXPECT_NEAR(brightness(MappedNormals::inverse_transpose), 0.494, 5e-4);
  }
}

// Any scale, any rotation, any texel: the mapped normal of the model times the inverse transpose of its matrix.
TEST(MappedNormals, AnyTransformAgainstAnInvertedMatrix) {
  const unsigned seed = 20260311;
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    Transform transform;
    transform.translation = {0.2 * number(random), 0.2 * number(random), 6};
    transform.scale = {std::exp(number(random)), std::exp(number(random)), std::exp(number(random))};
    if (trial % 3 == 0) transform.scale.x *= -1;
    transform.rotation = rotation_about(Axis::x, 40 * number(random)) * rotation_about(Axis::y, 40 * number(random)) *
                         rotation_about(Axis::z, 180 * number(random));
    const Vec3d stored = unit({number(random), number(random), 0.3 + std::abs(number(random))});
    const Vec3f texel(stored * 0.5 + Vec3d(0.5));
    const Scene scene = wall(texel, transform);
    const Mat3d m(transform.rotation[0] * transform.scale.x, transform.rotation[1] * transform.scale.y,
                  transform.rotation[2] * transform.scale.z);
    // In the model u runs along x, v falls along y; the front is -z, from which the axes follow.
    const Vec3d in_model = Vec3d{1, 0, 0} * stored.x + Vec3d{0, 1, 0} * stored.y + Vec3d{0, 0, -1} * stored.z;
    const Vec3d expected = unit(glm::transpose(glm::inverse(m)) * in_model);
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
      const Vec3d actual = normal_in_picture(scene, renderer, MappedNormals::inverse_transpose, Precision::float32);
      const double sense = dot(actual, expected) < 0 && std::abs(dot(actual, expected)) > 0.9 ? -1 : 1;
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(actual[axis] * sense, expected[axis], 2e-5) << "trial " << trial << ", axis " << axis;
    }
  }
}

// An equal scale does not stretch a relief: both ways give the same.
TEST(MappedNormals, EqualScaleMakesNoDifference) {
  Transform transform;
  transform.translation = {0, 0, 5};
  transform.scale = Vec3d(2.5);
  transform.rotation = rotation_about(Axis::y, 25) * rotation_about(Axis::x, -20);
  const Scene scene = wall({0.75f, 0.4f, 0.9f}, transform);
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const Vec3d a = normal_in_picture(scene, renderer, MappedNormals::world_frame, Precision::float32);
    const Vec3d b = normal_in_picture(scene, renderer, MappedNormals::inverse_transpose, Precision::float32);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-6);
  }
}

}  // namespace
}  // namespace ps::mapped_normals_test
