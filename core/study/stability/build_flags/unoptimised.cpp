#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild unoptimised_build() { return flag_build("-O0"); }

}  // namespace ps::stability
