#include "options/simd_choice.h"

#include "base/machine.h"
#include "hwy/targets.h"

namespace ps {

std::int64_t processor_targets() {
  static const std::int64_t targets = hwy::SupportedTargets();
  return targets;
}

std::optional<Simd> widest_simd(Simd setting) {
#if HWY_ARCH_X86
  const std::int64_t have = processor_targets();
  if (may_use(setting, Simd::avx512, have, HWY_AVX3)) return Simd::avx512;
  if (may_use(setting, Simd::avx2, have, HWY_AVX2)) return Simd::avx2;
  if (may_use(setting, Simd::sse4, have, HWY_SSE4)) return Simd::sse4;
#else
  static_cast<void>(setting);
#endif
  return {};
}

std::string_view chosen_simd(Simd setting) {
  std::int64_t chosen = 0;
#if HWY_ARCH_X86
  const std::int64_t have = processor_targets();
  if (may_use(setting, Simd::avx512, have, HWY_AVX3)) chosen |= HWY_AVX3;
  if (may_use(setting, Simd::avx2, have, HWY_AVX2)) chosen |= HWY_AVX2;
  if (may_use(setting, Simd::sse4, have, HWY_SSE4)) chosen |= HWY_SSE4;
#endif
  return simd_name(chosen);
}

}  // namespace ps
