#pragma once
#include <vector>

#include "options/option.h"

namespace ps::test {

/// All of them, as the option table has them.
inline std::vector<Accelerator> all_accelerators() {
  std::vector<Accelerator> all;
  const std::size_t count = find_option("accelerator")->choices.size();
  for (std::size_t i = 0; i < count; ++i) all.push_back(static_cast<Accelerator>(i));
  return all;
}

}  // namespace ps::test
