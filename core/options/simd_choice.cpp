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
  const std::optional<Simd> target = widest_simd(setting);
  if (!target) return simd_name(0);
#if HWY_ARCH_X86
  switch (*target) {
  case Simd::avx512:
    return simd_name(HWY_AVX3);
  case Simd::avx2:
    return simd_name(HWY_AVX2);
  case Simd::sse4:
    return simd_name(HWY_SSE4);
  case Simd::off:
  case Simd::automatic:
    break;
  }
#endif
  return simd_name(0);
}

}  // namespace ps
