#include "base/enumerators.h"

#include <fmt/ranges.h>

#include "base/check.h"

namespace ps {

void refuse_key(std::string_view what, std::string_view key, std::span<const std::string_view> known) {
  throw InputError(fmt::format("{}: found '{}', expected one of {}", what, key, fmt::join(known, " ")));
}

}  // namespace ps
