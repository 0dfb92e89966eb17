#include "base/check.h"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

namespace ps {
namespace {

std::string describe(const SourcePlace& place, const std::string& found, const std::string& expected) {
  std::string text = place.file;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.column > 0) text += fmt::format(":{}", place.column);
  if (!text.empty()) text += ": ";
  return text + fmt::format("found {}, expected {}", found, expected);
}

}  // namespace

InputError::InputError(SourcePlace place, std::string found, std::string expected)
    : std::runtime_error(describe(place, found, expected)), place_(std::move(place)), found_(std::move(found)),
      expected_(std::move(expected)) {}

InputError::InputError(const std::string& message) : std::runtime_error(message) {}

void assertion_failed(const char* condition, const char* file, int line, std::string_view message) {
  fmt::print(stderr, "{}:{}: assertion failed: {} ({})\n", file, line, condition, message);
  std::abort();
}

}  // namespace ps
