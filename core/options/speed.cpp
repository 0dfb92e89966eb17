#include "base/machine.h"
#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_octree(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (s.accelerator != Accelerator::octree) return "needs accelerator = octree";
  return {};
}

Reason needs_any_hit(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (!t.casting_lights) return "no light casts shadows";
  if (s.shadows == Shadows::none) return "needs shadows";
  if (!s.shadow_any_hit) return "needs shadow-any-hit";
  return {};
}

Reason needs_single(const Settings& s, const SceneTraits&) {
  if (s.precision != Precision::float32) return "Embree knows single precision only: the tree of boxes serves";
  return {};
}

Reason needs_boxes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_rays(s, t)) return reason;
  if (s.accelerator == Accelerator::none || s.accelerator == Accelerator::bounding_spheres)
    return "the accelerator has no boxes";
  const bool others = t.spheres || t.solids || t.csg;
  if (s.accelerator == Accelerator::embree && !needs_single(s, t) && !others) return "Embree tests its boxes itself";
  return {};
}

Option accelerator_row() {
  Option option = choice<&Settings::accelerator>(
      {.key = "accelerator",
       .label = "Accelerator",
       .help = {"What saves a ray from being tested against everything.", "CGFS ch. 5",
                "Only speed changes: the picture is the same to the last bit. Embree alone has its own arithmetic."},
       .truth = as_set(),
       .inactive = needs_rays,
       .effect = OptionEffect::speed},
      {{"bvh", "bounding-volume hierarchy", "A tree of boxes built with the surface-area heuristic."},
       {"none", "none", "Every ray is tested against every primitive."},
       {"bounding-spheres", "bounding spheres", "A sphere around each object, spheres around those, and within."},
       {"box", "one box", "Rays that miss the box around everything are done at once."},
       {"octree", "octree", "Space cut into eight parts, again and again; a triangle stands in all it touches."},
       {"two-level", "two levels",
        "A tree for each model, kept once however often it stands in the scene, and a tree over its instances."},
       {"embree", "Embree",
        "Intel's kernels, for triangles in float. Rays within rounding of an edge may find the neighbour, and are "
        "counted. Its nodes cannot be told.",
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
           .help = {"How a ray and a box are intersected.", "Kay and Kajiya 1986; Ize, JCGT 2013",
                    "The naive form loses boxes: 0 times infinity is no number, and corners are missed by a rounding."},
           .truth = exactly("slab-test=robust"),
           .inactive = needs_boxes},
          {{"robust", "robust", "Planes in the order of the ray, grown by rounding errors, and deaf to NaN."},
           {"naive", "naive", "Smaller and larger t of each pair of planes; on the clear path."}}),
      integer<&Settings::octree_leaf>(
          {.key = "octree-leaf",
           .label = "Octree leaf limit",
           .help =
               {"A cell with more primitives than this is cut into eight; those in the very same place count as one.",
                "octrees for ray casting",
                "Small limits copy large triangles into many cells; large ones test too much."},
           .truth = as_set(),
           .inactive = needs_octree,
           .effect = OptionEffect::speed},
          1, 256, "primitives"),
      integer<&Settings::octree_depth>({.key = "octree-depth",
                                        .label = "Octree depth",
                                        .help = {"How often a cell may be cut.", "octrees for ray casting",
                                                 "Where many triangles meet in a point, no depth is enough."},
                                        .truth = as_set(),
                                        .inactive = needs_octree,
                                        .effect = OptionEffect::speed},
                                       0, 16, "levels"),
      toggle<&Settings::shadow_cache>(
          {.key = "shadow-cache",
           .label = "Shadow cache",
           .help = {"What blocked a light last time in this tile is tested first.", "CGFS ch. 5",
                    "Gains only where shadows are large and the search is slow."},
           .truth = as_set(),
           .inactive = needs_any_hit,
           .effect = OptionEffect::speed}),
      toggle<&Settings::cache_constants>(
          {.key = "cache-constants",
           .label = "Cache constants",
           .help = {"What depends on the ray alone is computed once for each ray, not for each test.", "CGFS ch. 5",
                    "Only speed changes. Off, rays take the clear path."},
           .truth = as_set(),
           .inactive = needs_rays,
           .effect = OptionEffect::speed}),
      integer<&Settings::threads>(
          {.key = "threads",
           .label = "Threads",
           .help = {"How many processors work on a picture; 0 takes all.", "CGFS ch. 5", "Only speed changes."},
           .truth = as_set(),
           .effect = OptionEffect::speed},
          0, 256, "threads"),
      choice<&Settings::simd>(
          {.key = "simd",
           .label = "SIMD",
           .help =
               {"How many pixels, boxes or triangles one instruction works on.", "the fast path",
                "Only speed changes: every width gives the same bits. Triangles are found in a wider tree, so nodes "
                "and tests are counted differently. Double precision runs without it."},
           .truth = as_set(),
           .effect = OptionEffect::speed},
          {{"auto", "best there is", "The widest that this processor has."},
           {"off", "off", "The clear path: one after another."},
           {"sse4", "SSE4", "4 floats."},
           {"avx2", "AVX2", "8 floats."},
           {"avx512", "AVX-512", "16 floats."}}),
  };
}

}  // namespace ps::rows
