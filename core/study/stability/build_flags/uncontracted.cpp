#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild uncontracted_build() {
  return {"-mavx2 -mfma -ffp-contract=off",
          has_instructions,
          flag_watertight,
          flag_compared_products,
          flag_kahan_products,
          flag_moeller_trumbore,
          flag_book_picture};
}

}  // namespace ps::stability
