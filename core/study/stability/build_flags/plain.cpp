#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild plain_build() { return flag_build("as the program"); }

}  // namespace ps::stability
