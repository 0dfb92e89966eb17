#pragma once
#include <string>

namespace ps {

/// What results depend on besides the code.
struct Machine {
  std::string version;    ///< Pixelscope's
  std::string processor;  ///< as the system names it
  std::string simd;       ///< best instruction set of this processor that Pixelscope has code for
  int threads = 1;        ///< processors
};

Machine this_machine();

}  // namespace ps
