#include "base/machine.h"

#include <hwy/targets.h>

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
  const std::int64_t supported = hwy::SupportedTargets();
  for (const std::int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4})
    if ((supported & target) != 0) return hwy::TargetName(target);
  return "none";
}

}  // namespace

Machine this_machine() {
  return {std::string(version()), processor_name(), simd_name(), resolve_threads(ParallelOptions{})};
}

}  // namespace ps
