#include <cmath>

#include "accel/bvh.h"
#include "raytrace/clear/triangle_watertight.h"
#include "record/recorder.h"
#include "study/stability/half_tree.h"
#include "study/stability/support.h"

namespace ps::stability::bad_vertices {
namespace {

/// 3,200 triangles.
ClosedSphere small_sphere() { return closed_sphere(33, 50, 2, {0, 0, 0}); }

/// Percentages of rays from the centre that leave a sphere with this number of NaN vertices other than through its
/// holes, for each form of the boxes.
struct Escaping {
  double new_first = 0, accumulated_first = 0, fmin = 0;
};

Escaping escaping(std::size_t bad_vertices, const StabilityRun& run) {
  run.check();
  ClosedSphere mesh = small_sphere();
  Random random(run.seed);
  // The first bad one is at a third of the list: what was taken in before it is lost.
  for (std::size_t i = 0; i < bad_vertices; ++i)
    mesh.vertices[mesh.vertices.size() * (3 + i) / 10] = Vec3f(std::numeric_limits<float>::quiet_NaN());
  const HalfTree new_first(mesh, MinForm::new_first), accumulated_first(mesh, MinForm::accumulated_first);
  const HalfTree fmin(mesh, MinForm::fmin);
  Escaping escaped;
  double all = 0;
  const int rays = run.count(50000, 5000);
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(random.in_cube(0.2)), direction(random.direction());
    const Shear<float> shear(direction);
    const auto meets = [&](std::size_t k) {
      const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
      return hit.verdict == TriangleVerdict::inside && hit.t > 0;
    };
    bool met = false;
    for (std::size_t k = 0; k < mesh.triangles.size() && !met; ++k) met = meets(k);
    if (!met) continue;
    ++all;
    const auto lost = [&](const HalfTree& tree) {
      bool found = false;
      tree.for_each(SlabRay<float>(origin, direction, 0), [&](std::uint32_t k) { found = found || meets(k); });
      return found ? 0 : 1;
    };
    escaped.new_first += lost(new_first);
    escaped.accumulated_first += lost(accumulated_first);
    escaped.fmin += lost(fmin);
  }
  return {percent(escaped.new_first, all), percent(escaped.accumulated_first, all), percent(escaped.fmin, all)};
}

std::vector<StabilityRow> measure_nan(const StabilityRun& run) {
  Rows rows(run);
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    const Escaping escaped = escaping(bad, run);
    const auto knob = static_cast<double>(bad);
    rows.push_back({knob, "tree of halves", escaped.new_first, escaped.accumulated_first, "% of rays lost"});
    rows.push_back({knob, "tree of halves, std::fmin(new, accumulated)", std::nan(""), escaped.fmin, "% of rays lost"});
  }
  return rows;
}

using Triangles = std::vector<TracedTriangle<float>>;

/// The sphere, ring by ring, with one of its 1,602 vertices here.
Triangles rings(float bad_value) {
  ClosedSphere mesh = small_sphere();
  if (bad_value != 0) mesh.vertices[700] = Vec3f(bad_value);
  Triangles triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles.push_back(mesh.triangle(i));
  return triangles;
}

/// 5,000 small triangles anywhere in a cube of side 2, one of which has a vertex here.
Triangles soup(float bad_value, const StabilityRun& run) {
  Random place(run.seed + 1);
  Triangles triangles(5000);
  for (TracedTriangle<float>& triangle : triangles) {
    const Vec3d middle = place.in_cube(1);
    for (Vec3f* corner : {&triangle.a, &triangle.b, &triangle.c}) *corner = Vec3f(middle + place.in_cube(0.1));
  }
  if (bad_value != 0) triangles[1700].a = Vec3f(bad_value);
  return triangles;
}

double nodes_per_ray(const Triangles& triangles, const StabilityRun& run) {
  run.check();
  std::vector<Box<float>> boxes(triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const Vec3f& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) boxes[i].include(corner);
  const Bvh<float> bvh = build_bvh<float>(boxes, 1);
  Random random(run.seed);
  CountingRecorder nodes;
  const int rays = run.count(50000, 5000);
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(random.direction() * 5.0), direction(Vec3f(random.in_cube(1)) - origin);
    const Shear<float> shear(direction);
    float limit = std::numeric_limits<float>::infinity();
    for_each_candidate(
        bvh, SlabRay<float>(origin, direction, 0), limit,
        [&](std::uint32_t k) {
          const auto hit = triangle_watertight<float>(origin, shear, triangles[k], TriangleGuard::none);
          if (hit.verdict == TriangleVerdict::inside && hit.t > 0 && hit.t < limit) limit = hit.t;
          return false;
        },
        nodes);
  }
  return static_cast<double>(nodes.counters[Counter::node_visits]) / rays;
}

std::vector<StabilityRow> measure_infinite(const StabilityRun& run) {
  Rows rows(run);
  const auto measure = [&](const char* series, auto&& triangles) {
    const double without = nodes_per_ray(triangles(0.0f), run);
    for (const float value : {1e3f, 1e18f, 1e38f, std::numeric_limits<float>::infinity()})
      rows.push_back({value, series, nodes_per_ray(triangles(value), run), without, "nodes per ray"});
  };
  measure("5,000 triangles anywhere", [&](float value) { return soup(value, run); });
  measure("a sphere in rings", rings);
  return rows;
}

}  // namespace

static constexpr KnobCase nan_vertex_cases[]{{0, "no NaN"}, {1, "one NaN"}, {3, "three NaN"}};
static constexpr StabilitySeries nan_vertex_series[]{
    {.names = "*", .title = "rays that hit nothing any more", .unit = "%", .cases = nan_vertex_cases},
};

extern const StabilityExperiment nan_vertex{
    .key = "nan-vertex",
    .place = {Subject::boxes, 50},
    .title = "A NaN among the vertices",
    .keywords = "NaN, not a number, bad model, BVH",
    .knob = "vertices that are NaN",
    .naive = "std::min(new, accumulated)",
    .robust = "std::min(accumulated, new) or std::fmin, and refuse NaN on loading",
    .explanation = "std::min returns its first operand when either is NaN. With the new value first, one NaN wipes out "
                   "what a box held before, in every box above it.",
    .safe = "No NaN.",
    .window = {0, 0},
    .series = nan_vertex_series,
    .measure = measure_nan};

static constexpr StabilitySeries infinite_vertex_series[]{
    {.names = "*", .title = "boxes visited by a ray", .unit = "boxes"},
};

extern const StabilityExperiment infinite_vertex{
    .key = "infinite-vertex",
    .place = {Subject::boxes, 60},
    .title = "A vertex at infinity",
    .keywords = "infinity, overflow, bad model, bounding box",
    .knob = "coordinate of one vertex",
    .naive = "build with it",
    .robust = "refuse it",
    .explanation = "The surface areas of all boxes above are infinite, so the heuristic cannot compare splits and "
                   "halves the list in its order. Hits stay right, but the search slows down. If the triangles have no "
                   "order, each half fills the space of the whole, and halves, quarters and so on are searched one "
                   "after another. In a mesh, neighbours stay together.",
    .safe = "Coordinates whose squares are finite, up to 1e18.",
    .window = {nowhere, 1e18},
    .series = infinite_vertex_series,
    .measure = measure_infinite};

}  // namespace ps::stability::bad_vertices
