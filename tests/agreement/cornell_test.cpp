// Light on flat faces against its own equation: the lab's box, and the lamp that a face's corners hardly see.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::cornell_test {
namespace {

constexpr int size = 200;

Frame draw(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, size, size}, settings, request_for(Channel::ids | Channel::depth));
}

Settings unshadowed(const Scene& scene) {
  Settings settings = settings_for(scene);
  settings.shadows = Shadows::none;
  return settings;
}

/// What the pixel shows: the ray through it at the depth that is stored. The lab's camera looks along z, y down.
Vec3d point_at(const Frame& frame, int x, int y) {
  const double z = frame.depth.at(x, y);
  return Vec3d{((x + 0.5) / size - 0.5) * z, ((y + 0.5) / size - 0.5) * z, -3.001 + z};
}

// LAB 6.1: D = P max(r.n, 0) / (4 pi r r), R = rho (D + N), with P = 1.1, N = 0.5 and the lamp at (0, -0.5, -0.7).
TEST(CornellBox, EachPixelShowsTheLabsEquation) {
  const Scene scene = load_scene("lab/cornell");
  const Frame frame = draw(scene, unshadowed(scene));
  int compared = 0;
  double brightest = 0;
  for (int y = 0; y < size; y += 3)
    for (int x = 0; x < size; x += 3) {
      const PixelId id = frame.ids.at(x, y);
      if (id.object < 0) continue;
      const auto& instance = std::get<Instance>(scene.geometry->objects[static_cast<std::size_t>(id.object)].shape);
      const Mesh& mesh = *scene.geometry->meshes[instance.mesh];
      const auto& corner = mesh.triangles[static_cast<std::size_t>(id.triangle)].position;
      const Vec3d normal = cross(mesh.positions[corner[1]] - mesh.positions[corner[0]],
                                 mesh.positions[corner[2]] - mesh.positions[corner[0]]);
      const Vec3d r = Vec3d(0, -0.5, -0.7) - point_at(frame, x, y);
      const double square = dot(r, r);
      const double cosine = dot(normal, r) / std::sqrt(dot(normal, normal) * square);
      const double light = 0.5 + 1.1 * std::max(cosine, 0.0) / (4 * std::numbers::pi * square);
      const Vec3d expected = material_of(scene, id.object, id.triangle).colour * light;
      for (int i = 0; i < 3; ++i) ASSERT_NEAR(frame.colour.at(x, y)[i], expected[i], 2e-3) << x << ", " << y;
      brightest = std::max(brightest, light);
      ++compared;
    }
  EXPECT_GT(compared, 3000);
  EXPECT_GT(brightest, 0.8);
}

TEST(CornellBox, LiesWithinTheLabsCube) {
  const Scene scene = load_scene("lab/cornell");
  for (const auto& mesh : scene.geometry->meshes)
    for (const Vec3d& p : mesh->positions)
      for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(p[i]), 1.00001);
  EXPECT_EQ(scene.camera.position, Vec3d(0, 0, -3.001));
}

/// The largest difference between two pictures, levels of 255.
double largest_difference(const Frame& a, const Frame& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.colour.pixels().size(); ++i) {
    const Vec3f d = a.colour.pixels()[i] - b.colour.pixels()[i];
    most = std::max({most, std::abs(double(d.x)), std::abs(double(d.y)), std::abs(double(d.z))});
  }
  return 255 * most;
}

// LAB 6.1 and Figure 7: light from the corners loses the bright spots; positions that are not divided by z are skewed,
// which shows nowhere else, as nothing but the light reads them.
TEST(CornellBox, LosesItsBrightSpotsPerVertexAndSkewsThemWithoutDivision) {
  const Scene scene = load_scene("lab/cornell");
  Settings settings = unshadowed(scene);
  const Frame right = draw(scene, settings);
  settings.interpolation = Interpolation::affine;
  EXPECT_GT(largest_difference(right, draw(scene, settings)), 10);
  settings.interpolation = Interpolation::perspective;
  settings.shading = Shading::gouraud;
  EXPECT_GT(largest_difference(right, draw(scene, settings)), 40);
  settings.shading = Shading::phong;
  settings.renderer = Renderer::ray_tracer;
  const Frame traced = draw(scene, settings);
  int differing = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (traced.ids.at(x, y) != right.ids.at(x, y)) continue;
      const Vec3f d = traced.colour.at(x, y) - right.colour.at(x, y);
      if (std::abs(d.x) + std::abs(d.y) + std::abs(d.z) > 1.0f / 255) ++differing;
    }
  EXPECT_EQ(differing, 0) << "with division the two renderers agree";
}

// CGFS Figure 13-7: a lamp 0.3 before the middle of a face whose corners are 2 sqrt(2) away from there.
TEST(NearLight, CornersMissWhatTheMiddleSees) {
  const Scene scene = load_scene("cgfs/near-light");
  Settings settings = unshadowed(scene);
  const double corner = 0.1 + 0.9 * 0.3 / std::sqrt(2.0 * 2 + 2 * 2 + 0.3 * 0.3);
  settings.shading = Shading::gouraud;
  EXPECT_NEAR(draw(scene, settings).colour.at(size / 2, size / 2).x, corner, 1e-4);
  settings.shading = Shading::phong;
  EXPECT_NEAR(draw(scene, settings).colour.at(size / 2, size / 2).x, 1.0, 1e-2);
}

}  // namespace
}  // namespace ps::cornell_test
