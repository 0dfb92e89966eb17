#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

// PS_HAS_X87 comes from cmake/BuildFlags.cmake: whether the compiler has the flag.
FlagBuild x87_build() {
#if PS_HAS_X87
  return flag_build("-mfpmath=387");
#else
  return flag_build("-mfpmath=387", [] { return false; });
#endif
}

}  // namespace ps::stability
