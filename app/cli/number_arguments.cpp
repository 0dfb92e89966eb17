#include "cli/number_arguments.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/check.h"

namespace ps::cli {

TileRect parse_region(const std::string& text) {
  std::array<int, 4> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  bool good = true;
  for (std::size_t i = 0; i < numbers.size() && good; ++i) {
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    good = error == std::errc() && (i == 3 ? next == end : next != end && *next == ',');
    at = next + 1;
  }
  const auto [x, y, width, height] = numbers;
  constexpr int most = 1 << 20;
  if (!good || x < 0 || y < 0 || width < 1 || height < 1 || x > most || y > most || width > most || height > most)
    throw InputError(fmt::format("region: found '{}', expected X,Y,W,H in pixels", text));
  return {x, y, x + width, y + height};
}

}  // namespace ps::cli
