#include "base/return_free_memory.h"

#include <cstdlib>  // says whether it is of the GNU C library

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace ps {

void return_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace ps
