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

}  // namespace

bool has_embree() {
#ifdef PIXELSCOPE_EMBREE
  return true;
#else
  return false;
#endif
}

Machine this_machine() {
  static const std::string processor = processor_name();  // asks the system, and every export names it
  return {std::string(version()), processor, std::string(simd_name(hwy::SupportedTargets())),
          resolve_threads(ParallelOptions{})};
}

std::string_view simd_name(std::int64_t targets) {
#if HWY_ARCH_X86
  if ((targets & HWY_AVX3) != 0) return "AVX-512";  // Highway's word is AVX3
  if ((targets & HWY_AVX2) != 0) return "AVX2";
  if ((targets & HWY_SSE4) != 0) return "SSE4";
#endif
  return "none";
}

}  // namespace ps
