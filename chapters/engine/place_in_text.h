#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

#include "base/check.h"

namespace ps {

/// The place of byte `offset` of a text that begins at `start`.
inline SourcePlace place_in(std::string_view text, std::size_t offset, const SourcePlace& start) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto lines = static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  const auto newline = before.rfind('\n');
  if (newline == std::string_view::npos)
    return {start.file, start.line, start.column + static_cast<int>(before.size())};
  return {start.file, start.line + lines, static_cast<int>(before.size() - newline)};
}

}  // namespace ps
