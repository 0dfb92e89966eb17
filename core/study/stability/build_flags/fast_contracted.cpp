#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild fast_contracted_build() { return flag_build("-mfma -ffast-math", has_instructions); }

}  // namespace ps::stability
