#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild fast_build() { return flag_build("-ffast-math"); }

}  // namespace ps::stability
