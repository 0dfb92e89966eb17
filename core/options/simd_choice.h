#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

#include "hwy/detect_compiler_arch.h"
#include "options/settings.h"

// A file that is compiled once for each SIMD target keeps three of them; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3

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

/// chosen_kernel() in a file that is compiled once for each target: `kernel` is a function or constant of its
/// HWY_NAMESPACE, or a call. The second is for a file that is not compiled for SSE4.
#if HWY_ARCH_X86
#define PS_CHOSEN_KERNEL(Kernel, setting, kernel)                                                                      \
  ps::chosen_kernel<Kernel>(setting, N_AVX3::kernel, N_AVX2::kernel, N_SSE4::kernel)
#define PS_CHOSEN_WIDE_KERNEL(Kernel, setting, kernel)                                                                 \
  ps::chosen_kernel<Kernel>(setting, N_AVX3::kernel, N_AVX2::kernel)
#else
#define PS_CHOSEN_KERNEL(Kernel, setting, kernel) (static_cast<void>(setting), Kernel())
#define PS_CHOSEN_WIDE_KERNEL(Kernel, setting, kernel) PS_CHOSEN_KERNEL(Kernel, setting, kernel)
#endif

/// simd_name() of the target that kernels choose under this setting.
std::string_view chosen_simd(Simd setting);

}  // namespace ps
