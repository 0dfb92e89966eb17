#include <array>

#include <glm/geometric.hpp>

#include "study/stability/closed_sphere.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::cracks_in_an_image {
namespace {

using Vertices = std::array<std::uint32_t, 3>;

/// In which order a triangle names its vertices. Moeller-Trumbore computes the weights u and v of the second and third
/// one, so it compares u and v with 0 at two edges, and the rounded sum u + v with 1 at the third, which lies opposite
/// the first vertex.
enum class Order {
  as_generated,
  meridian_opposite  ///< the edge along the meridian lies opposite the first vertex
};

Vertices ordered(const ClosedSphere& sphere, const Vertices& v, Order order) {
  if (order == Order::as_generated) return v;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d a(sphere.vertices[v[(k + 1) % 3]]), b(sphere.vertices[v[(k + 2) % 3]]);
    const double apart = std::abs(a.x * b.z - a.z * b.x);
    if (apart < 1e-6 && std::abs(a.y - b.y) > 1e-6) return {v[k], v[(k + 1) % 3], v[(k + 2) % 3]};
  }
  return v;
}

/// The closed sphere seen from its centre: only cracks show the background.
Scene inside_of_sphere(Order order) {
  const ClosedSphere sphere = closed_sphere(160, 320, 2, {0, 0, 0});
  Mesh mesh;
  for (const Vec3f& vertex : sphere.vertices) mesh.positions.emplace_back(vertex);
  for (const Vertices& vertices : sphere.triangles)
    mesh.triangles.emplace_back().position = ordered(sphere, vertices, order);
  Scene scene = plain_scene("sphere", std::move(mesh));
  scene.camera.viewport_width = scene.camera.viewport_height = 2;
  scene.camera.projection_plane_d = 1;
  return scene;
}

double uncovered(const Scene& scene, int size, TriangleTest test, Precision precision, const StabilityRun& run) {
  Settings settings;
  settings.near = 0;
  settings.triangle_test = test;
  settings.precision = precision;
  const Frame frame = picture_of(scene, {scene.camera, size, size}, settings, Channel::ids, run);
  double count = 0;
  for (const PixelId& id : frame.ids.pixels()) count += id.object < 0 ? 1 : 0;
  return count;
}

/// A camera near the centre that looks anywhere, so that no edge is aligned with it.
Camera turned(Camera camera, Random& random) {
  camera.forward = random.direction();
  camera.right = glm::normalize(cross(random.direction(), camera.forward));
  camera.up = cross(camera.forward, camera.right);
  camera.position = random.in_cube(0.1);
  return camera;
}

void measure(const StabilityRun& run, Rows& rows) {
  constexpr const char* unit = "px see through";
  const auto add = [&](const std::string& series, const Scene& scene, int size, Precision precision) {
    rows.add(size, series, uncovered(scene, size, TriangleTest::moeller_trumbore, precision, run),
             uncovered(scene, size, TriangleTest::watertight, precision, run), unit);
  };
  const int even = run.side(2048, 512), odd = run.side(2049, 513), odd_before = run.side(2047, 511);
  const Scene aligned = inside_of_sphere(Order::meridian_opposite);
  for (const int size : {odd_before, even, odd, run.side(2051, 515)}) add("float", aligned, size, Precision::float32);
  for (const int size : {odd_before, odd}) add("double", aligned, size, Precision::float64);
  Scene scene = inside_of_sphere(Order::as_generated);
  add("float, other order of vertices", scene, odd, Precision::float32);
  // A few pixels in each: the sum of several pictures.
  Random random(run.seed);
  double naive = 0, robust = 0;
  for (int i = 0; i < 4; ++i) {
    scene.camera = turned(scene.camera, random);
    naive += uncovered(scene, even, TriangleTest::moeller_trumbore, Precision::float32, run);
    robust += uncovered(scene, even, TriangleTest::watertight, Precision::float32, run);
  }
  rows.add(even, "float, turned cameras, four pictures", naive, robust, unit);
}

}  // namespace

extern const StabilityExperiment cracks_in_an_image{
    .key = "cracks-in-an-image",
    .place = {Subject::rays, 100},
    .title = "Cracks in a picture",
    .keywords = "holes, watertight, seams, light leak",
    .knob = "side of the picture (px)",
    .naive = "Moeller-Trumbore (triangle-test = moeller-trumbore)",
    .robust = "watertight (Woop; triangle-test = watertight)",
    .explanation =
        "With an odd number of columns the middle one looks exactly along a meridian of the mesh. Where that edge lies "
        "opposite the first vertex of its triangles, one pixel in five slips through; in any other view or order of "
        "vertices, one in a million does.",
    .safe = "Views that no edge is aligned with; no size is safe for every view.",
    .window = nowhere_safe,
    .series =
        {{.names = "float|*", .title = "pixels that show the background", .unit = "px", .between = Between::nothing}},
    .add_rows = measure};

}  // namespace ps::stability::cracks_in_an_image
