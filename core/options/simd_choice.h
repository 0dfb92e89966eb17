#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "options/settings.h"

namespace ps {

/// The targets that the processor has, as hwy::SupportedTargets() gives them. Asked for once: the question itself takes
/// tens of microseconds on a virtual machine.
std::int64_t processor_targets();

/// Whether code for a SIMD target may run: the processor has it (`bit` of `supported`) and the setting does not ask for
/// less. A setting that the processor lacks gives the best one below it.
inline bool may_use(Simd setting, Simd target, std::int64_t supported, std::int64_t bit) {
  if (setting == Simd::off || (supported & bit) == 0) return false;
  return setting == Simd::automatic || static_cast<int>(setting) >= static_cast<int>(target);
}

/// The target that runs with this setting on this processor; none with `off` and on processors without SSE4.
std::optional<Simd> widest_simd(Simd setting);

/// The version of a kernel for that target, of those that were compiled; Kernel{} where none runs.
template <class Kernel>
Kernel chosen_kernel(Simd setting, const Kernel& avx512, const Kernel& avx2, const Kernel& sse4 = {}) {
  const std::optional<Simd> target = widest_simd(setting);
  if (target == Simd::avx512) return avx512;
  if (target == Simd::avx2) return avx2;
  if (target == Simd::sse4) return sse4;
  return {};
}

/// simd_name() of the target that kernels choose under this setting.
std::string_view chosen_simd(Simd setting);

}  // namespace ps
