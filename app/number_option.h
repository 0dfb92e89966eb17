// Checks for the numbers of command-line options, for both programs. CLI11's own ranges let NaN pass, for it is neither
// below nor above anything, and its numbers may be octal, hexadecimal or infinite.
#pragma once
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "base/number_text.h"
#include "base/spelling.h"

namespace ps {

/// Takes what `allowed` says of the number that parse_number() finds in the text; `expected` is for the message.
template <class Allowed>
CLI::Validator number_check(Allowed allowed, const std::string& expected) {
  const auto check = [allowed, expected](const std::string& text) {
    const auto number = parse_number(text);
    return number && allowed(*number) ? std::string()
                                      : fmt::format("found '{}', expected {}", shown_start(text), expected);
  };
  return {check, expected};
}

/// A finite number from `low` to `high`, both allowed.
inline CLI::Validator number_from(double low, double high) {
  return number_check([=](double number) { return number >= low && number <= high; },
                      fmt::format("a number from {} to {}", low, high));
}

/// A finite number above `low`.
inline CLI::Validator number_above(double low) {
  return number_check([=](double number) { return number > low; }, fmt::format("a number above {}", low));
}

/// Digits with an optional sign, from `low` to `high`, both allowed.
inline CLI::Validator whole_number_from(std::int64_t low, std::int64_t high) {
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  const auto check = [=](const std::string& text) {
    const std::string digits = text.substr(text.starts_with('-') ? 1 : 0);
    const bool plain = !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos &&
                       (digits.size() == 1 || digits.front() != '0');  // 010 would be read as 8
    const auto number = plain ? parse_number(text) : std::nullopt;
    const bool allowed = number && *number >= static_cast<double>(low) && *number <= static_cast<double>(high);
    return allowed ? std::string() : fmt::format("found '{}', expected {}", shown_start(text), expected);
  };
  return {check, expected};
}

}  // namespace ps
