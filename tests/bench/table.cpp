#include "bench/bench.h"

namespace ps::bench {

// One line for each file of benches; they are listed by hand so that nothing depends on the linker.
Benches memory_benches();

Benches all_benches() {
  Benches all;
  append(all, memory_benches());
  return all;
}

}  // namespace ps::bench
