#pragma once
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "support/environment.h"

namespace ps::test {

/// Random numbers that PIXELSCOPE_TEST_SEED repeats. What fails while it lives names its seed.
class SeededRandom : public std::mt19937 {
 public:
  explicit SeededRandom(unsigned seed = test_seed())
      : std::mt19937(seed), trace_(__FILE__, __LINE__, "PIXELSCOPE_TEST_SEED=" + std::to_string(seed)) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(*this); }

 private:
  testing::ScopedTrace trace_;
};

}  // namespace ps::test
