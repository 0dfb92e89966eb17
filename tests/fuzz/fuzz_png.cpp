#include <string>

#include "fuzz/libfuzzer.h"
#include "fuzz/mend_png.h"

PS_FUZZ("png")

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

/// Most changes would end at a wrong checksum; three of four get a right one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  const std::size_t changed = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 4 == 0) return changed;
  std::string bytes(reinterpret_cast<const char*>(data), changed);
  ps::fuzz::mend_png(bytes);
  bytes.copy(reinterpret_cast<char*>(data), changed);
  return changed;
}
