#include "options/rows.h"

namespace ps::rows {

std::vector<Option> speed_rows() {
  return {
      choice<&Settings::accelerator>(
          {.key = "accelerator",
           .label = "Accelerator",
           .help = {"What saves a ray from being tested against everything.", "CGFS ch. 5",
                    "Only speed changes: the picture is the same to the last bit."},
           .inactive = needs_rays,
           .effect = OptionEffect::speed},
          {{"bvh", "bounding-volume hierarchy", "A tree of boxes built with the surface-area heuristic."},
           {"none", "none", "Every ray is tested against every primitive."}}),
      integer<&Settings::threads>(
          {.key = "threads",
           .label = "Threads",
           .help = {"How many processors work on a picture; 0 takes all.", "CGFS ch. 5", "Only speed changes."},
           .effect = OptionEffect::speed},
          0, 256, "threads"),
      choice<&Settings::simd>(
          {.key = "simd",
           .label = "SIMD",
           .help =
               {"How many pixels, boxes or triangles one instruction works on.", "the fast path",
                "Only speed changes: every width gives the same bits. Triangles are found in a wider tree, so nodes "
                "and tests are counted differently. Double precision runs without it."},
           .effect = OptionEffect::speed},
          {{"auto", "best there is", "The widest that this processor has."},
           {"off", "off", "The clear path: one after another."},
           {"sse4", "SSE4", "4 floats."},
           {"avx2", "AVX2", "8 floats."},
           {"avx512", "AVX-512", "16 floats."}}),
  };
}

}  // namespace ps::rows
