#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "frame/frame.h"
#include "hwy/targets.h"
#include "options/simd_choice.h"

namespace ps::test {

/// The choices of `simd` whose instructions this processor has, narrowest first. Empty: whatever is chosen, everything
/// takes the clear path, and a test of the fast one proves nothing.
inline std::vector<Simd> simd_targets() {
  std::vector<Simd> targets;
  if (!HWY_ARCH_X86) return targets;
  for (const auto& [target, bit] :
       {std::pair{Simd::sse4, std::int64_t{HWY_SSE4}}, {Simd::avx2, HWY_AVX2}, {Simd::avx512, HWY_AVX3}})
    if (may_use(target, target, processor_targets(), bit)) targets.push_back(target);
  return targets;
}

/// Whether the rasterizer drew the frame on the fast path of whole pictures, which alone names this stage.
inline bool took_fast_frame(const Frame& frame) {
  return std::any_of(frame.times.begin(), frame.times.end(),
                     [](const StageTime& time) { return time.stage == "triangles, sorted into tiles"; });
}

}  // namespace ps::test
