#include <utility>
#include <vector>

#include "raytrace/clear/intersector.h"
#include "study/stability/octree_shortcuts.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::grid_octree_borders {
namespace {

using Primitives = Intersector<double, Silent>;

/// 2,000 balls of radius 0.02 in a cube of side 1.
Scene balls_in_cube(Random& random) {
  constexpr double radius = 0.02;
  Geometry geometry;
  for (int i = 0; i < 2000; ++i)
    geometry.objects.push_back({"", Sphere{Vec3d(0.5) + random.in_cube(0.5 - radius), radius, 0}});
  return plain_scene(std::move(geometry));
}

/// 2,000 right triangles with legs of 0.08 along the axes, each in a plane at a whole number of sixteenths inside a
/// cube of side 1: where there are 16 or 64 cells along a side, all these planes are borders of cells. Two more
/// triangles, in opposite vertices of the cube and too small to be hit, make it the tree's box.
Scene triangles_on_borders(Random& random) {
  constexpr double leg = 0.08;
  Mesh mesh;
  const auto add = [&](const Vec3d& corner, int axis, double length) {
    Vec3d second = corner, third = corner;
    second[(axis + 1) % 3] += length;
    third[(axis + 2) % 3] += length;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {corner, second, third});
    mesh.triangles.emplace_back().position = {first, first + 1, first + 2};
  };
  for (int i = 0; i < 2000; ++i) {
    const int axis = static_cast<int>(random.below(3));
    Vec3d corner(random.between(0, 1 - leg), random.between(0, 1 - leg), random.between(0, 1 - leg));
    corner[axis] = static_cast<double>(1 + random.below(15)) / 16;
    add(corner, axis, leg);
  }
  add(Vec3d(0), 0, 1e-6);
  add(Vec3d(1), 0, -1e-6);
  return plain_scene("triangles", std::move(mesh));
}

TraceInputs<double> inputs_with(const Scene& scene, Accelerator accelerator, int depth, Prepared& prepared) {
  Settings settings;
  settings.precision = Precision::float64;
  settings.accelerator = accelerator;
  settings.octree_leaf = 0;  // cells with one primitive are cut as well, so all cells are equally large
  settings.octree_depth = depth;
  return make_trace_inputs<double>(scene, {scene.camera, 1, 1}, settings, prepared);
}

/// A ray from 2 before the centre of the cube to any point of it, with what it meets first.
struct KnownRay {
  Ray<double> ray;
  double t;
};

/// The rays that hit something, of this number from all directions; every primitive was tested.
std::vector<KnownRay> known_rays(const Scene& scene, Random& random, const StabilityRun& run) {
  Prepared prepared;
  Silent silent;
  const TraceInputs<double> inputs = inputs_with(scene, Accelerator::none, 0, prepared);
  const Primitives all(inputs, silent);
  std::vector<KnownRay> known;
  for (int i = run.count(20000, 3000); i > 0; --i) {
    if (i % 1024 == 0) run.check();
    Ray<double> ray;
    ray.origin = Vec3d(0.5) + random.direction() * 2.0;
    ray.direction = Vec3d(0.5) + random.in_cube(0.5) - ray.origin;
    ray.t_max = everywhere;
    if (const Hit<double> hit = all.nearest(ray); hit.found()) known.push_back({ray, hit.t});
  }
  return known;
}

/// Percentage of hits that a search misses, or takes for one farther away.
class Wrong {
 public:
  void add(const KnownRay& known, const Hit<double>& found) {
    wrong_ += found.found() && found.t <= known.t ? 0 : 1;
    ++all_;
  }
  double share() const { return percent(wrong_, all_); }

 private:
  double wrong_ = 0, all_ = 0;
};

/// The program's octree, and searches of it that are wrong.
class Search {
 public:
  Search(const Scene& scene, int depth)
      : inputs_(inputs_with(scene, Accelerator::octree, depth, prepared_)), octree_(inputs_, silent_),
        by_centre_(octree_with(InCells::of_its_centre, *inputs_.geometry,
                               *accelerator_as<Octree<double>>(inputs_.accelerator), depth)),
        on_one_side_(octree_with(InCells::of_one_side, *inputs_.geometry,
                                 *accelerator_as<Octree<double>>(inputs_.accelerator), depth)) {}

  Wrong of_program(const std::vector<KnownRay>& rays) const {
    Wrong wrong;
    for (const KnownRay& known : rays) wrong.add(known, octree_.nearest(known.ray));
    return wrong;
  }
  /// The program's search of cells that hold centres alone.
  Wrong of_centres(const std::vector<KnownRay>& rays) {
    Wrong wrong;
    for (const auto& [ray, t] : rays) {
      const CandidateRay<double> candidate{ray.origin, ray.direction, 0, SlabForm::robust};
      Hit<double> best;
      best.t = everywhere;
      const Ray<double>& tested = ray;
      const auto visit = [&](std::uint32_t primitive) {
        const Hit<double> hit = octree_.one(tested, primitive);
        if (hit.found() && hit.t < best.t) best = hit;
        return false;
      };
      for_each_candidate(by_centre_, candidate, best.t, visit, silent_);
      wrong.add({ray, t}, best);
    }
    return wrong;
  }
  enum class Cells { program, on_one_side };
  Wrong of_shortcut(const std::vector<KnownRay>& rays, Shortcut shortcut, Cells cells = Cells::program) const {
    ShortSearch search(cells == Cells::program ? *accelerator_as<Octree<double>>(inputs_.accelerator) : on_one_side_,
                       octree_, inputs_.geometry->primitives.size());
    Wrong wrong;
    for (const KnownRay& known : rays) wrong.add(known, search.nearest(known.ray, shortcut));
    return wrong;
  }

 private:
  Prepared prepared_;
  Silent silent_;
  TraceInputs<double> inputs_;
  Primitives octree_;
  Octree<double> by_centre_, on_one_side_;
};

void measure(const StabilityRun& run, Rows& rows) {
  Random random(run.seed);
  const Scene balls = balls_in_cube(random), flat = triangles_on_borders(random);
  const std::vector<KnownRay> at_balls = known_rays(balls, random, run), at_flat = known_rays(flat, random, run);
  for (const int depth : {2, 4, 6}) {
    const double side = 1 << depth;
    const auto add = [&](const char* series, const Wrong& naive, const Wrong& robust) {
      rows.add(side, series, naive.share(), robust.share(), "% of hits missed or wrong");
    };
    Search round(balls, depth);
    const Wrong program = round.of_program(at_balls);
    add("centres alone", round.of_centres(at_balls), program);
    add("mailbox and t <= cell exit", round.of_shortcut(at_balls, Shortcut::mailbox), program);
    add("first hit wins", round.of_shortcut(at_balls, Shortcut::first_hit_wins), program);
    add("t <= cell exit, tested in each cell", round.of_shortcut(at_balls, Shortcut::reject_beyond), program);
    Search borders(flat, depth);
    const Wrong on_borders = borders.of_program(at_flat);
    const auto exit = [&](Search::Cells cells) { return borders.of_shortcut(at_flat, Shortcut::reject_beyond, cells); };
    add("triangles on borders, centres alone", borders.of_centres(at_flat), on_borders);
    add("triangles on borders, t <= cell exit", exit(Search::Cells::program), on_borders);
    add("triangles on borders, kept on one side, t <= cell exit", exit(Search::Cells::on_one_side), on_borders);
  }
}

}  // namespace

extern const StabilityExperiment grid_octree_borders{
    .key = "grid-octree-borders",
    .place = {Subject::boxes, 40},
    .title = "Borders of octree cells",
    .keywords = "octree, grid, spatial index, missed hit",
    .knob = "cells along a side",
    .naive = "short cuts in where primitives are kept and in when the search ends",
    .robust = "keep a primitive in every cell it touches, and the nearest hit until no cell begins before it",
    .explanation = "A ball that reaches into other cells is not found there, or it is found in one cell and hit in "
                   "another. The position of the hit must decide, not the cell that was searched.",
    .safe = "Nowhere.",
    .window = nowhere_safe,
    .series = {{.names = "centres alone|*",
                .title = "hits that are missed, and hits of the wrong primitive",
                .unit = "%"}},
    .add_rows = measure};

}  // namespace ps::stability::grid_octree_borders
