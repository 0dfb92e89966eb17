#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

namespace {
bool has_x87() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  return true;
#else
  return false;
#endif
}
}  // namespace

FlagBuild x87_build() { return flag_build("-mfpmath=387", has_x87); }

}  // namespace ps::stability
