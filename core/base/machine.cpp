#include "base/machine.h"

#include <hwy/highway.h>

#include <fstream>

#include "base/parallel.h"
#include "base/version.h"

namespace ps {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  const std::string label = "model name";
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, label.size(), label) != 0) continue;
    const std::size_t start = line.find_first_not_of(" \t", line.find(':') + 1);
    if (start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

std::string simd_name() {
#if HWY_ARCH_X86
  const std::int64_t supported = hwy::SupportedTargets();
  // In the makers' words: Highway calls the first "AVX3".
  if ((supported & HWY_AVX3) != 0) return "AVX-512";
  if ((supported & HWY_AVX2) != 0) return "AVX2";
  if ((supported & HWY_SSE4) != 0) return "SSE4";
#endif
  return "none";
}

}  // namespace

Machine this_machine() {
  return {std::string(version()), processor_name(), simd_name(), resolve_threads(ParallelOptions{})};
}

}  // namespace ps
