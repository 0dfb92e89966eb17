#include <cmath>
#include <limits>

#include "raytrace/clear/triangle_watertight.h"
#include "study/stability/closed_sphere.h"
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

void measure_nan(const StabilityRun& run, Rows& rows) {
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    const Escaping escaped = escaping(bad, run);
    const auto knob = static_cast<double>(bad);
    rows.add(knob, "tree of halves", escaped.new_first, escaped.accumulated_first, "% of rays lost");
    rows.add(knob, "tree of halves, std::fmin(new, accumulated)", std::nan(""), escaped.fmin, "% of rays lost");
  }
}

}  // namespace

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
    .series = {{.names = "*",
                .title = "rays that hit nothing any more",
                .unit = "%",
                .cases = {{0, "no NaN"}, {1, "one NaN"}, {3, "three NaN"}}}},
    .add_rows = measure_nan};

}  // namespace ps::stability::bad_vertices
