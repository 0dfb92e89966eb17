#include "accel/bvh.h"
#include "raytrace/clear/triangle_watertight.h"
#include "study/stability/aimed_rays.h"

namespace ps::stability::bvh_holes {
namespace {

struct FloatRay {
  Vec3f origin, direction;
};

/// A closed sphere in the program's tree of boxes, searched with its watertight triangle test. The ray tracer also
/// grows all boxes by a margin for other primitives; without it what the slab test does alone is seen.
class Search {
 public:
  explicit Search(const ClosedSphere& mesh) : mesh_(mesh) {
    std::vector<Box<float>> boxes(mesh.triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (const std::uint32_t corner : mesh.triangles[i]) boxes[i].include(mesh.vertices[corner]);
    tree_ = build_bvh<float>(boxes, {.threads = 1});
  }

  /// Whether the search for the nearest hit finds none; counts the nodes that it visits.
  bool misses(const FloatRay& ray, SlabForm form, CountingRecorder& work) const {
    float nearest = infinity;
    const Shear<float> shear(ray.direction);
    const auto visit = [&](std::uint32_t k) {
      const auto hit = triangle_watertight<float>(ray.origin, shear, mesh_.triangle(k), TriangleGuard::none);
      if (hit.verdict == TriangleVerdict::inside && hit.t > 0) nearest = std::min(nearest, hit.t);
      return false;
    };
    for_each_candidate(tree_, SlabRay<float>(ray.origin, ray.direction, 0, form), nearest, visit, work);
    return nearest == infinity;
  }

  /// Whether a ray is lost where boxes are entered only if near < far: a mistake that the program does not offer, so
  /// the tree is walked here.
  bool misses_strictly(const FloatRay& ray) const {
    const SlabRay<float> slabs(ray.origin, ray.direction, 0, SlabForm::naive);
    const Shear<float> shear(ray.direction);
    std::vector<std::uint32_t> waiting{0};
    while (!waiting.empty()) {
      const BvhNode<float>& node = tree_.nodes[waiting.back()];
      waiting.pop_back();
      for (std::uint32_t i = 0; i < node.count; ++i) {
        const TracedTriangle<float> triangle = mesh_.triangle(tree_.order[node.first + i]);
        const auto hit = triangle_watertight<float>(ray.origin, shear, triangle, TriangleGuard::none);
        if (hit.verdict == TriangleVerdict::inside && hit.t > 0) return false;
      }
      if (node.count != 0) continue;
      for (const std::uint32_t child : {node.first, node.first + 1}) {
        const SlabRange<float> range = slab_test(slabs, tree_.nodes[child].box, infinity);
        if (range.near < range.far) waiting.push_back(child);
      }
    }
    return true;
  }

 private:
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  const ClosedSphere& mesh_;
  Bvh<float> tree_;
};

struct Holes {
  double naive = 0, strict = 0, robust = 0;  ///< misses per million rays
  double naive_nodes = 0, robust_nodes = 0;  ///< visited, per ray
};

/// Rays from the centre of a closed sphere of 101,760 triangles to its vertices or edges: none may leave it.
Holes holes_at(const Vec3d& centre, AimAt what, const StabilityRun& run) {
  run.check();
  const ClosedSphere mesh = closed_sphere(160, 320, 2, centre);
  const Search search(mesh);
  CountingRecorder naive_work, robust_work;
  Random random(run.seed);
  Holes holes;
  const int rays = run.count(200000, 40000);
  for (int i = 0; i < rays; ++i) {
    if (i % 65536 == 0) run.check();
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
    const FloatRay ray{origin, Vec3f(target - Vec3d(origin))};
    holes.naive += search.misses(ray, SlabForm::naive, naive_work) ? 1 : 0;
    holes.robust += search.misses(ray, SlabForm::robust, robust_work) ? 1 : 0;
    if (what == AimAt::vertex) holes.strict += search.misses_strictly(ray) ? 1 : 0;
  }
  const auto nodes = [&](const CountingRecorder& work) {
    return static_cast<double>(work.counters[Counter::node_visits]) / rays;
  };
  return {per_million(holes.naive, rays), per_million(holes.strict, rays), per_million(holes.robust, rays),
          nodes(naive_work), nodes(robust_work)};
}

void measure(const StabilityRun& run, Rows& rows) {
  // For a knob of 1e5 the sphere's centre lies at far_centre.
  for (const double distance : {0.0, 1e3, 1e5}) {
    const Holes holes = holes_at(far_centre * (distance / 1e5), AimAt::vertex, run);
    rows.add(distance, "rays at vertices", holes.naive, holes.robust, "misses per million rays");
    rows.add(distance, "near < far, rays at vertices", holes.strict, holes.robust, "misses per million rays");
    rows.add(distance, "cost", holes.naive_nodes, holes.robust_nodes, "nodes per ray");
  }
  const Holes holes = holes_at(far_centre, AimAt::edge, run);
  rows.add(1e5, "rays at edges", holes.naive, holes.robust, "misses per million rays");
}

}  // namespace

extern const StabilityExperiment bvh_holes{
    .key = "bvh-holes",
    .place = {Subject::boxes, 20},
    .title = "Holes in a tree of boxes",
    .keywords = "BVH, bounding box, overlap, missed hit, cracks",
    .knob = "distance of the sphere from the origin (world units)",
    .naive = "near <= far, as computed (slab-test = naive)",
    .robust = "far end grown by its rounding error, 2 gamma(3) (slab-test = robust)",
    .explanation =
        "A watertight triangle test does not help if the box around the triangle is missed. Rays at vertices run "
        "along edges of boxes at every level of the tree.",
    .safe = "Nowhere for rays that are aimed at vertices.",
    .window = nowhere_safe,
    .series = {{.names = "rays at vertices|*", .title = "rays that miss the mesh", .unit = "per million"},
               {.names = "cost", .title = "nodes visited by a ray", .unit = "nodes"}},
    .add_rows = measure};

}  // namespace ps::stability::bvh_holes
