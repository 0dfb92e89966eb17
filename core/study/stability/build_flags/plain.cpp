#include "study/stability/build_flags/kernels-inl.h"

namespace ps::stability {

FlagBuild plain_build() {
  return {"as the program", [] { return true; }, flag_watertight, flag_moeller_trumbore, flag_book_picture};
}

}  // namespace ps::stability
