#include <cstdio>
#include <cstdlib>

#include "base/check.h"

// In place of base/check.cpp, which needs a library to format its messages.

namespace ps {

InputError::InputError(SourcePlace place, std::string found, std::string expected)
    : std::runtime_error("found " + found + ", expected " + expected), place_(std::move(place)),
      found_(std::move(found)), expected_(std::move(expected)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

void assertion_failed(const char* condition, const char* file, int line, std::string_view message) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, condition, std::string(message).c_str());
  std::abort();
}

}  // namespace ps
