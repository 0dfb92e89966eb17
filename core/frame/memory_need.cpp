#include "frame/memory_need.h"

#include "base/available_memory.h"

namespace ps {

void require(const MemoryNeed& need, const Prepared& prepared) {
  auto available = available_memory();
  if (available) *available += prepared.bytes();
  require_memory(need.bytes, available, need.what, need.cure);
}

}  // namespace ps
