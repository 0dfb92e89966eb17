#include "accel/bvh.h"
#include "inspect/recorder.h"
#include "raytrace/triangle_watertight.h"
#include "study/stability/half_tree.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// 3,200 triangles.
ClosedSphere small_sphere() { return closed_sphere(33, 50, 2, {0, 0, 0}); }

/// Percentage of rays from the middle that leave a sphere of which one vertex is NaN, other than through its hole.
double escaping(MinForm form, std::size_t bad_vertices, const StabilityRun& run) {
  run.check();
  ClosedSphere mesh = small_sphere();
  Random random(run.seed);
  // The first bad one stands at a third of the list: what was taken in before it is lost.
  for (std::size_t i = 0; i < bad_vertices; ++i)
    mesh.vertices[mesh.vertices.size() * (3 + i) / 10] = Vec3f(std::numeric_limits<float>::quiet_NaN());
  const HalfTree tree(mesh, form);
  double escaped = 0, all = 0;
  const int rays = run.count(50000, 5000);
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(random.in_cube(0.2)), direction(random.direction());
    bool met = false;
    const Shear<float> shear(direction);
    for (std::size_t k = 0; k < mesh.triangles.size() && !met; ++k) {
      const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
      met = hit.verdict == TriangleVerdict::inside && hit.t > 0;
    }
    if (!met) continue;
    ++all;
    bool found = false;
    tree.for_each(SlabRay<float>(origin, direction, 0), [&](std::uint32_t k) {
      const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
      found = found || (hit.verdict == TriangleVerdict::inside && hit.t > 0);
    });
    escaped += found ? 0 : 1;
  }
  return percent(escaped, all);
}

std::vector<StabilityRow> measure_nan(const StabilityRun& run) {
  Rows rows(run);
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1}, std::size_t{3}})
    rows.push_back({static_cast<double>(bad), "tree of halves", escaping(MinForm::new_first, bad, run),
                    escaping(MinForm::accumulated_first, bad, run), "% of rays lost"});
  return rows;
}

/// How triangles follow each other in the list.
enum class Order { rings, any };

double work_per_ray(float bad_value, Order order, const StabilityRun& run) {
  run.check();
  ClosedSphere mesh = small_sphere();
  if (bad_value != 0) mesh.vertices[700] = Vec3f(bad_value);
  if (order == Order::any) {
    Random place(run.seed + 1);
    for (std::size_t i = mesh.triangles.size() - 1; i > 0; --i)
      std::swap(mesh.triangles[i], mesh.triangles[place.below(i + 1)]);
  }
  std::vector<Box<float>> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const std::uint32_t corner : mesh.triangles[i]) boxes[i].include(mesh.vertices[corner]);
  const Bvh<float> bvh = build_bvh<float>(boxes, 1);
  Random random(run.seed);
  CountingRecorder nodes;
  const int rays = run.count(50000, 5000);
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(random.direction() * 5.0), direction(Vec3f(random.in_cube(1.5)) - origin);
    const Shear<float> shear(direction);
    float limit = std::numeric_limits<float>::infinity();
    for_each_candidate(
        bvh, SlabRay<float>(origin, direction, 0), limit,
        [&](std::uint32_t k) {
          nodes.count(Counter::triangle_tests);
          const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
          if (hit.verdict == TriangleVerdict::inside && hit.t > 0 && hit.t < limit) limit = hit.t;
          return false;
        },
        nodes);
  }
  return static_cast<double>(nodes.counters[Counter::node_visits] + nodes.counters[Counter::triangle_tests]) / rays;
}

std::vector<StabilityRow> measure_infinite(const StabilityRun& run) {
  Rows rows(run);
  for (const Order order : {Order::rings, Order::any}) {
    const double without = work_per_ray(0, order, run);
    const char* series = order == Order::rings ? "one vertex of 1,602, triangles in rings"
                                               : "one vertex of 1,602, triangles in any order";
    for (const float value : {1e3f, 1e18f, 1e38f, std::numeric_limits<float>::infinity()})
      rows.push_back({value, series, work_per_ray(value, order, run), without, "nodes and triangles per ray"});
  }
  return rows;
}

}  // namespace

const StabilityExperiment nan_vertex{
    .key = "nan-vertex",
    .title = "A NaN among the vertices",
    .knob = "vertices that are NaN",
    .naive = "std::min(new, accumulated)",
    .robust = "std::min(accumulated, new), and refuse NaN on loading",
    .explanation = "std::min returns its first operand when either is NaN. With the new value first, one NaN wipes out "
                   "what a box held before, in every box above it.",
    .safe = "No NaN.",
    .window = {0, 0},
    .measure = measure_nan};

const StabilityExperiment infinite_vertex{
    .key = "infinite-vertex",
    .title = "A vertex at infinity",
    .knob = "coordinate of one vertex",
    .naive = "build with it",
    .robust = "refuse it",
    .explanation =
        "The surface areas of all boxes above are infinite, so the heuristic cannot tell good splits from bad ones and "
        "the list is halved as it stands: hits stay right, the search slows down. How much depends on the list: "
        "neighbours that stand together stay together, and in any other order both halves fill the same room.",
    .safe = "Coordinates whose squares are finite, up to 1e18.",
    .window = {nowhere, 1e18},
    .measure = measure_infinite};

}  // namespace ps::stability
