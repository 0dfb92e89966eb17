#pragma once
#include <cstdlib>
#include <random>

namespace ps::test {

/// The number in an environment variable, or `otherwise`.
inline double number_from(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtod(text, nullptr) : otherwise;
}

/// PIXELSCOPE_TEST_SEED, which repeats a run, or `otherwise`.
inline unsigned test_seed(unsigned otherwise = std::random_device{}()) {
  return static_cast<unsigned>(number_from("PIXELSCOPE_TEST_SEED", otherwise));
}

}  // namespace ps::test
