#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild uncontracted_build() {
  return {"-mavx2 -mfma -ffp-contract=off", has_instructions, flag_watertight, flag_moeller_trumbore,
          flag_book_picture};
}

}  // namespace ps::stability
