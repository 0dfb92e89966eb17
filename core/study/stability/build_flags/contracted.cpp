#include "study/stability/build_flags/instructions-inl.h"
#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild contracted_build() {
  return {"-mfma -ffp-contract=fast", has_instructions,      flag_watertight,  flag_compared_products,
          flag_kahan_products,        flag_moeller_trumbore, flag_book_picture};
}

}  // namespace ps::stability
