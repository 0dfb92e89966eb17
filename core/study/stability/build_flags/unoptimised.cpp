#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild unoptimised_build() {
  return {"-O0",
          [] { return true; },
          flag_watertight,
          flag_compared_products,
          flag_kahan_products,
          flag_moeller_trumbore,
          flag_book_picture};
}

}  // namespace ps::stability
