#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild plain_build() {
  return {"as the program",    [] { return true; },   flag_watertight,  flag_compared_products,
          flag_kahan_products, flag_moeller_trumbore, flag_book_picture};
}

}  // namespace ps::stability
