#include "raytrace/triangle_watertight.h"
#include "study/stability/aimed_rays.h"
#include "study/stability/half_tree.h"

namespace ps::stability {
namespace {

struct Holes {
  double naive = 0, strict = 0, robust = 0;  ///< misses per million rays
  double naive_nodes = 0, robust_nodes = 0;  ///< visited, per ray
};

Holes holes_at(const Vec3d& centre, AimAt what, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, 2, centre);
  const HalfTree tree(mesh, MinForm::accumulated_first);
  Random random(run.seed);
  Holes holes;
  const int rays = run.count(200000, 40000);
  for (int i = 0; i < rays; ++i) {
    // Added as floats: where doubles are narrowed and widened again, GCC 12 vectorises the rounding away, and a ray
    // that starts a little beside its origin misses the vertex that it is aimed at.
    const Vec3f origin = Vec3f(centre) + Vec3f(random.in_cube(0.5));
    Vec3d target;
    if (what == AimAt::vertex) {
      target = Vec3d(mesh.vertices[random.below(mesh.vertices.size())]);
    } else {
      const auto& corners = mesh.triangles[random.below(mesh.triangles.size())];
      const std::size_t side = random.below(3);
      const Vec3d a(mesh.vertices[corners[side]]), b(mesh.vertices[corners[(side + 1) % 3]]);
      target = a + (b - a) * random.unit();
    }
    const Vec3f direction(target - Vec3d(origin));
    const Shear<float> shear(direction);
    const auto lost = [&](SlabForm form, bool strict, double& nodes) {
      bool found = false;
      const auto visit = [&](std::uint32_t k) {
        const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
        found = found || (hit.verdict == TriangleVerdict::inside && hit.t > 0);
      };
      nodes += static_cast<double>(
          tree.for_each(SlabRay<float>(origin, direction, 0, form), visit,
                        [&](const SlabRange<float>& range) { return strict ? range.near < range.far : range.hit(); }));
      return found ? 0.0 : 1.0;
    };
    double ignored = 0;
    holes.naive += lost(SlabForm::naive, false, holes.naive_nodes);
    if (what == AimAt::vertex) holes.strict += lost(SlabForm::naive, true, ignored);
    holes.robust += lost(SlabForm::robust, false, holes.robust_nodes);
  }
  return {per_million(holes.naive, rays), per_million(holes.strict, rays), per_million(holes.robust, rays),
          holes.naive_nodes / rays, holes.robust_nodes / rays};
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  // For a knob of 1e5 the world's middle lies at far_centre.
  for (const double distance : {0.0, 1e3, 1e5}) {
    const Holes holes = holes_at(far_centre * (distance / 1e5), AimAt::vertex, run);
    rows.push_back({distance, "rays at vertices", holes.naive, holes.robust, "misses per million rays"});
    rows.push_back({distance, "near < far, rays at vertices", holes.strict, holes.robust, "misses per million rays"});
    rows.push_back({distance, "cost", holes.naive_nodes, holes.robust_nodes, "nodes per ray"});
  }
  const Holes holes = holes_at(far_centre, AimAt::edge, run);
  rows.push_back({1e5, "rays at edges", holes.naive, holes.robust, "misses per million rays"});
  return rows;
}

}  // namespace

const StabilityExperiment bvh_holes{
    .key = "bvh-holes",
    .title = "Holes in a tree of boxes",
    .knob = "offset of the world from the origin",
    .naive = "near <= far of the slabs",
    .robust = "far end grown by 2 gamma(3)",
    .explanation =
        "A watertight triangle does not help if the box around it is missed. Rays at vertices run along edges "
        "of boxes all the way down the tree.",
    .safe = "Nowhere for rays that are aimed at vertices.",
    .window = nowhere_safe,
    .measure = measure};

}  // namespace ps::stability
