#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

namespace {
bool has_instructions() {
#if defined(__x86_64__) && defined(__FMA__) && defined(__AVX2__)
  return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#elif defined(__aarch64__)
  return true;
#else
  return false;
#endif
}
}  // namespace

FlagBuild uncontracted_build() {
  return {"-mavx2 -mfma -ffp-contract=off", has_instructions, flag_watertight, flag_moeller_trumbore,
          flag_book_picture};
}

}  // namespace ps::stability
