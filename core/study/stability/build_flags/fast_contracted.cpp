#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

namespace {
bool has_fma() {
#if defined(__x86_64__) && defined(__FMA__)
  return __builtin_cpu_supports("fma");
#elif defined(__aarch64__)
  return true;
#else
  return false;
#endif
}
}  // namespace

FlagBuild fast_contracted_build() {
  return {"-mfma -ffast-math", has_fma, flag_watertight, flag_moeller_trumbore, flag_book_picture};
}

}  // namespace ps::stability
