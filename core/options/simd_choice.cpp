#include "options/simd_choice.h"

#include "hwy/targets.h"

namespace ps {

std::int64_t processor_targets() {
  static const std::int64_t targets = hwy::SupportedTargets();
  return targets;
}

}  // namespace ps
