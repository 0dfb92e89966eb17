#include "base/machine.h"
#include "options/rows.h"
#include "options/simd_choice.h"

namespace ps::rows {
namespace {

Reason needs_octree(const Settings& s, const SceneTraits&) {
  if (s.accelerator != Accelerator::octree) return needs("accelerator", Accelerator::octree);
  return {};
}

Reason needs_any_hit(const Settings& s, const SceneTraits& t) {
  if (!t.casting_lights) return "no light casts shadows";
  if (const auto reason = needs_traced_shadows(s)) return reason;
  if (!s.shadow_any_hit) return needs("shadow-any-hit", true).said("needs shadow-any-hit");
  return {};
}

Reason needs_single(const Settings& s, const SceneTraits&) {
  if (s.precision != Precision::float32)
    return needs("precision", Precision::float32)
        .said("Embree supports single precision only: the BVH is used instead");
  return {};
}

Reason needs_boxes(const Settings& s, const SceneTraits& t) {
  if (s.accelerator == Accelerator::none || s.accelerator == Accelerator::bounding_spheres)
    return needs("accelerator", Accelerator::box).said("no effect: the accelerator has no boxes");
  const bool others = t.spheres || t.solids || t.csg;
  if (s.accelerator == Accelerator::embree && !needs_single(s, t) && !others)
    return needs("accelerator", Accelerator::box).said("no effect: Embree tests its boxes itself");
  return {};
}

bool narrower_than_avx2(const Settings& s, const SceneTraits&) {
  const std::optional<Simd> target = widest_simd(s.simd);
  return !target || *target == Simd::sse4;
}

Option accelerator_row() {
  Option option = choice<&Settings::accelerator>(
      {.key = "accelerator",
       .label = "Accelerator",
       .help =
           {"The data structure that saves intersection tests.", "CGFS ch. 5",
            "Only speed changes. With the watertight triangle test all pictures are the same to the last bit, except "
            "for Embree's own arithmetic. The others may hit a stretched triangle outside of its box, by rounding: "
            "what looks into the box finds less than testing everything."},
       .keywords = "BVH, octree, bounding box, kd-tree, spatial index, hierarchy, speed, Embree",
       .truth = as_set(),
       .acts_for = ActsFor::rays,
       .effect = OptionEffect::speed,
       .known_to = {.fast = {knows(sphere_packets, 120, Accelerator::bvh, Accelerator::none),
                             limit(triangle_search, 20, "Embree's kernels search, scalar code shades",
                                   [](const Settings& s, const SceneTraits&) {
                                     return s.accelerator == Accelerator::embree && has_embree();
                                   }),
                             knows(triangle_search, 21, Accelerator::bvh, Accelerator::octree, Accelerator::none,
                                   Accelerator::two_level, Accelerator::embree)
                                 .said("SIMD searches need accelerator = bvh, octree, two-level or none")},
                    .hardware = not_asked},
       .shown_by = {.experiments = {{"grid-octree-borders"}, {"bvh-holes"}, {"nan-vertex"}, {"tree-growth"}},
                    .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}},
      {{"bvh", "bounding-volume hierarchy", "A tree of boxes built with the surface-area heuristic."},
       {"none", "none", "Every ray is tested against every primitive."},
       {"bounding-spheres", "bounding spheres", "A hierarchy of spheres around objects and around groups of them."},
       {"box", "one box", "Rays that miss the bounding box of the whole scene need no test."},
       {"octree", "octree",
        "Space split into eight cells, again and again; a triangle is listed in every cell that it touches."},
       {"two-level", "two levels",
        "One tree for each model, stored once for all its instances, and a tree over the instances."},
       {"embree", "Embree",
        "Intel's kernels, for triangles in float. Rays within a rounding error of an edge may hit the neighbour; they "
        "are counted. Its node visits cannot be shown.",
        needs_single}});
  if (!has_embree()) option.choices.pop_back();
  option.maximum = static_cast<double>(option.choices.size()) - 1;
  return option;
}

}  // namespace

std::vector<Option> speed_rows() {
  return {
      accelerator_row(),
      choice<&Settings::slab_test>(
          {.key = "slab-test",
           .label = "Slab test",
           .help = {"The intersection test of a ray and a bounding box.", "Kay and Kajiya 1986; Ize, JCGT 2013",
                    "The naive form misses boxes: 0 times infinity is NaN, and rounding misses box corners."},
           .keywords = "ray box, bounding box, AABB, NaN, infinity",
           .truth = exactly("slab-test=robust"),
           .acts_for = ActsFor::rays,
           .inactive = needs_boxes,
           .known_to = {.fast = {knows(triangle_search, 30, SlabTest::robust)}, .hardware = not_asked},
           .shown_by = {.experiments = {{"bvh-holes", is_not<&Settings::slab_test, SlabTest::robust>,
                                         "slab-test=robust"},
                                        {"slab-test-false-miss"},
                                        {"0-inf-nan-slab"}},
                        .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}},
          {{"robust", "robust",
            "Planes in the order of the ray; interval widened by the rounding error; safe for NaN."},
           {"naive", "naive", "Minimum and maximum t of each pair of planes; runs on the clear path."}}),
      integer<&Settings::octree_leaf>(
          {.key = "octree-leaf",
           .label = "Octree leaf limit",
           .help = {"A cell with more primitives than this is split into eight; coincident primitives count as one.",
                    "octrees for ray casting",
                    "Too small: large triangles are listed in many cells. Too large: rays test too many primitives."},
           .keywords = "octree, leaf size, split, accelerator",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .inactive = needs_octree,
           .effect = OptionEffect::speed,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"grid-octree-borders"}}, .scenes = {{"cgfs/shading", "accelerator=octree"}}}},
          1, 256, "primitives"),
      integer<&Settings::octree_depth>(
          {.key = "octree-depth",
           .label = "Octree depth",
           .help = {"Maximum number of times that a cell is split.", "octrees for ray casting",
                    "No depth is enough where many triangles meet in a point."},
           .keywords = "octree, levels, split, accelerator",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .inactive = needs_octree,
           .effect = OptionEffect::speed,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"grid-octree-borders"}}, .scenes = {{"cgfs/shading", "accelerator=octree"}}}},
          0, 16, "levels"),
      toggle<&Settings::shadow_cache>(
          {.key = "shadow-cache",
           .label = "Shadow cache",
           .help = {"Tests first the object that last blocked the same light in this tile.", "CGFS ch. 5",
                    "Gains only if shadows are large and the search is slow."},
           .keywords = "last occluder, shadow buffer, speed",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .inactive = needs_any_hit,
           .effect = OptionEffect::speed,
           .known_to = {.fast = {knows(sphere_packets, 110, false), knows(hit_shading, 60, false)},
                        .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}}),
      toggle<&Settings::cache_constants>(
          {.key = "cache-constants",
           .label = "Cache constants",
           .help = {"Computes what depends on the ray alone once per ray instead of once per test.", "CGFS ch. 5",
                    "Only speed changes. Off, rays take the clear path."},
           .keywords = "precompute, loop invariant, speed",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .effect = OptionEffect::speed,
           .known_to = {.fast = {knows(sphere_packets, 100, true), knows(triangle_search, 10, true)},
                        .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}}),
      integer<&Settings::threads>(
          {.key = "threads",
           .label = "Threads",
           .help = {"Number of threads that render a picture; 0 = one per processor.", "CGFS ch. 5",
                    "Only speed changes."},
           .keywords = "cores, parallel, multithreading, speed",
           .truth = as_set(),
           .acts_for = ActsFor::picture,
           .effect = OptionEffect::speed,
           .known_to = {.fast = any_value, .hardware = lacking("the driver chooses its own threads")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          0, 256, "threads"),
      choice<&Settings::simd>(
          {.key = "simd",
           .label = "SIMD",
           .help = {"The instruction set, which decides how many pixels, boxes or triangles one instruction works on.",
                    "the fast path",
                    "Only speed changes: every width gives the same bits. Wider trees change the counts of nodes and "
                    "tests. Double precision runs without SIMD."},
           .keywords = "vector, SSE, AVX, parallel, speed",
           .truth = as_set(),
           .acts_for = ActsFor::picture,
           .effect = OptionEffect::speed,
           .known_to = {.fast = {limit(any, 20, "simd = off",
                                       [](const Settings& s, const SceneTraits&) { return s.simd == Simd::off; }),
                                 limit(any, 30, "this processor has no SSE4",
                                       [](const Settings& s, const SceneTraits&) { return !widest_simd(s.simd); }),
                                 limit(hit_shading, 70, "SIMD shading of hits needs AVX2", narrower_than_avx2)},
                        .hardware = lacking("the driver chooses its own instructions")},
           .shown_by = {.experiments = none,
                        .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}, {"octree/headline"}}}},
          {{"auto", "automatic", "The widest instruction set of this processor."},
           {"off", "off", "The clear path: one value after another."},
           {"sse4", "SSE4", "4 floats."},
           {"avx2", "AVX2", "8 floats."},
           {"avx512", "AVX-512", "16 floats."}}),
  };
}

}  // namespace ps::rows
