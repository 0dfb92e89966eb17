#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild contracted_build() { return flag_build("-mfma -ffp-contract=fast", has_instructions); }

}  // namespace ps::stability
