#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild fast_contracted_build() {
  return {"-mfma -ffast-math", has_instructions, flag_watertight, flag_moeller_trumbore, flag_book_picture};
}

}  // namespace ps::stability
