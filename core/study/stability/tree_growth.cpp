#include <array>
#include <cmath>

#include "scene/generate/displaced_sphere.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::tree_growth {
namespace {

/// A bumpy ball of 12 divisions^2 triangles, seen so near that every ray meets it.
Scene ball_of(int divisions) {
  Scene scene = plain_scene("ball", make_displaced_sphere({.divisions = divisions}));
  scene.camera.position = {0, 0, -3};
  scene.camera.viewport_width = scene.camera.viewport_height = 0.4;
  return scene;
}

/// Tests of triangles and visits of nodes for each of 32 x 32 eye rays. Counts do not depend on the machine.
double work_of_ray(const Scene& scene, Accelerator accelerator, const StabilityRun& run) {
  Settings settings;
  settings.accelerator = accelerator;
  settings.lighting = false;
  settings.shadows = Shadows::none;
  settings.reflection_depth = 0;
  settings.simd = Simd::off;
  const Frame frame = picture_of(scene, {scene.camera, 32, 32}, settings, Channel::none, run);
  const double work = static_cast<double>(frame.counters[Counter::triangle_tests]) +
                      static_cast<double>(frame.counters[Counter::node_visits]);
  return work / static_cast<double>(frame.counters[Counter::eye_rays]);
}

struct GrowingTree {
  const char* name;
  Accelerator accelerator;
  double before = 0;  ///< its work for a quarter of the triangles
};

void measure_trees(const StabilityRun& run, Rows& rows) {
  std::array trees{GrowingTree{"bounding-volume hierarchy", Accelerator::bvh},
                   GrowingTree{"octree", Accelerator::octree},
                   GrowingTree{"bounding spheres", Accelerator::bounding_spheres}};
  double all_before = 0;
  for (int divisions = 1; divisions <= 32; divisions *= 2) {
    const Scene scene = ball_of(divisions);
    const double n = 12.0 * divisions * divisions;
    const double all = work_of_ray(scene, Accelerator::none, run);
    for (GrowingTree& tree : trees) {
      const double work = work_of_ray(scene, tree.accelerator, run);
      rows.add(n, tree.name, all, work, "tests and visits");
      if (divisions > 1)
        rows.add(n, std::string("exponent, ") + tree.name, std::log(all / all_before) / std::log(4.0),
                 std::log(work / tree.before) / std::log(4.0), "power of n");
      tree.before = work;
    }
    all_before = all;
  }
}

}  // namespace

extern const StabilityExperiment tree_growth{
    .key = "tree-growth",
    .place = {Subject::boxes, 60},
    .title = "Trees grow with the logarithm",
    .keywords = "n against log n, octree, BVH, complexity, number of triangles, accelerator",
    .knob = "triangles of the model",
    .naive = "every triangle tested",
    .robust = "a tree",
    .explanation =
        "Without a tree each ray tests all n triangles: the exponent is 1. In a tree, four times as many triangles are "
        "a few levels more, so the exponent of its work falls towards 0, as that of log n does.",
    .safe = "A dozen triangles: there a tree saves little.",
    .window = {0, 12},
    .series = {{.names = "exponent, *",
                .title = "measured exponent, from a quarter of the triangles to all",
                .unit = "power of n"},
               {.names = "*", .title = "tests and node visits for each ray", .unit = "tests and visits"}},
    .add_rows = measure_trees};

}  // namespace ps::stability::tree_growth
