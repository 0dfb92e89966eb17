#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild uncontracted_build() { return flag_build("-mavx2 -mfma -ffp-contract=off", has_instructions); }

}  // namespace ps::stability
