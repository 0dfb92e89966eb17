#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ps {

/// The parts of a machine on which results depend, besides the code.
struct Machine {
  std::string version;    ///< Pixelscope's
  std::string processor;  ///< as the system names it
  std::string simd;       ///< best instruction set of this processor that Pixelscope has code for
  int threads = 1;        ///< processors
};

Machine this_machine();

/// Was this program built with Embree (Intel's ray tracing kernels)?
bool has_embree();

/// The best instruction set that Pixelscope has code for among `targets` (bits of hwy::SupportedTargets()), as its
/// maker calls it: "AVX-512", "AVX2" or "SSE4"; "none" without any.
std::string_view simd_name(std::int64_t targets);

}  // namespace ps
