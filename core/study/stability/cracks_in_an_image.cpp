#include <array>
#include <memory>

#include "study/stability/closed_sphere.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// The triangle with the edge along its meridian opposite the first corner, where Moeller-Trumbore compares a sum with
/// 1: that sum is rounded, while the two other edges of a meridian in the view's middle plane give exact zeros.
std::array<std::uint32_t, 3> meridian_last(const ClosedSphere& sphere, const std::array<std::uint32_t, 3>& c) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d a(sphere.vertices[c[(k + 1) % 3]]), b(sphere.vertices[c[(k + 2) % 3]]);
    const double apart = std::abs(a.x * b.z - a.z * b.x);
    if (apart < 1e-6 && std::abs(a.y - b.y) > 1e-6) return {c[k], c[(k + 1) % 3], c[(k + 2) % 3]};
  }
  return c;
}

/// The closed sphere seen from its middle: nothing but cracks shows the background.
Scene inside_of_sphere() {
  const ClosedSphere sphere = closed_sphere(160, 320, 2, {0, 0, 0});
  auto mesh = std::make_shared<Mesh>();
  for (const Vec3f& vertex : sphere.vertices) mesh->positions.emplace_back(vertex);
  for (const auto& corners : sphere.triangles) {
    MeshTriangle triangle;
    triangle.position = meridian_last(sphere, corners);
    mesh->triangles.push_back(triangle);
  }
  mesh->materials = {0};
  Geometry geometry;
  geometry.meshes = {std::move(mesh)};
  geometry.objects.push_back({"sphere", Instance{}});
  Scene scene;
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>({Material{}});
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

/// A camera that no edge is aligned with: turned about all three axes, and not quite in the middle.
void turn(Camera& camera) {
  const Vec3d forward = glm::normalize(Vec3d(0.36, -0.21, 0.79)),
              right = glm::normalize(cross(Vec3d(0.13, 1, 0.07), forward));
  camera.forward = forward;
  camera.right = right;
  camera.up = cross(forward, right);
  camera.position = {0.11, -0.07, 0.05};
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Scene scene = inside_of_sphere();
  Rows rows(run);
  const auto add = [&](const std::string& series, int size, Precision precision) {
    rows.push_back({static_cast<double>(size), series,
                    uncovered(scene, size, TriangleTest::moeller_trumbore, precision, run),
                    uncovered(scene, size, TriangleTest::watertight, precision, run), "px see through"});
  };
  for (const int size : {run.side(2047, 511), run.side(2048, 512), run.side(2049, 513), run.side(2051, 515)}) {
    add("float", size, Precision::float32);
    add("double", size, Precision::float64);
  }
  turn(scene.camera);
  for (const int size : {run.side(2047, 511), run.side(2048, 512), run.side(2049, 513)})
    add("float, turned camera", size, Precision::float32);
  return rows;
}

}  // namespace

const StabilityExperiment cracks_in_an_image{
    .key = "cracks-in-an-image",
    .title = "Cracks in a picture",
    .knob = "side of the picture (px)",
    .naive = "Moeller-Trumbore",
    .robust = "watertight (Woop)",
    .explanation = "With an odd number of columns the middle one looks exactly along a meridian of the mesh, and one "
                   "pixel in five there slips through. With an even number hardly any ray meets an edge.",
    .safe = "Views that no edge is aligned with; no size is safe for every view.",
    .window = nowhere_safe,
    .measure = measure};

}  // namespace ps::stability
