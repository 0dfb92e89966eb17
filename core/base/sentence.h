#pragma once
#include <span>
#include <string>
#include <string_view>

namespace ps {

/// "a, b and c"; `last` in place of "and".
std::string listed(std::span<const std::string> words, std::string_view last = "and");

/// With a capital at its beginning, if that is a letter from a to z.
std::string begun_large(std::string text);

}  // namespace ps
