// Rays and trees of hostile numbers: libFuzzer chooses the numbers.
#include <cstddef>
#include <cstdint>

#include "fuzz/hostile_rays.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ps::fuzz::search_as_bytes_say({reinterpret_cast<const char*>(data), size});
  return 0;
}
