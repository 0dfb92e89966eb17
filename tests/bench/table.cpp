#include "bench/bench.h"

namespace ps::bench {

// One line for each file of benches; they are listed by hand so that nothing depends on the linker.
Benches clear_resolve_benches();
Benches coverage_benches();
Benches gains_benches();
Benches window_path_benches();
Benches headline_benches();
Benches inspect_benches();
Benches hardware_story_benches();
Benches memory_benches();
Benches needs_benches();
Benches packets_benches();
Benches recorder_benches();
Benches rays_curve_benches();
Benches fragments_curve_benches();
#ifdef PIXELSCOPE_EMBREE
Benches embree_benches();
#endif
#ifdef PIXELSCOPE_LLVMPIPE
Benches llvmpipe_benches();
#endif

Benches all_benches() {
  Benches all;
  append(all, memory_benches());
  append(all, clear_resolve_benches());
  append(all, recorder_benches());
  append(all, packets_benches());
  append(all, gains_benches());
  append(all, window_path_benches());
  append(all, coverage_benches());
  append(all, headline_benches());
  append(all, needs_benches());
  append(all, inspect_benches());
  append(all, hardware_story_benches());
#ifdef PIXELSCOPE_EMBREE
  append(all, embree_benches());
#endif
#ifdef PIXELSCOPE_LLVMPIPE
  append(all, llvmpipe_benches());
#endif
  append(all, rays_curve_benches());
  append(all, fragments_curve_benches());
  return all;
}

}  // namespace ps::bench
