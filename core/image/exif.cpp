#include "image/exif.h"

#include <cstddef>
#include <cstdint>

namespace ps {
namespace {

/// A whole number in the byte order of the block; 0 beyond its end.
std::uint32_t exif_number(std::string_view block, std::size_t at, std::size_t size) {
  if (at > block.size() || block.size() - at < size) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(block[at + (block[0] == 'I' ? size - 1 - i : i)]);
  return value;
}

}  // namespace

int exif_orientation(std::string_view block) {
  constexpr std::uint32_t orientation_tag = 274;
  constexpr std::size_t entry_size = 12;
  if (!block.starts_with("II") && !block.starts_with("MM")) return 1;
  const std::size_t directory = exif_number(block, 4, 4);
  const std::size_t entries = exif_number(block, directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * entry_size;
    if (exif_number(block, entry, 2) != orientation_tag) continue;
    const std::uint32_t value = exif_number(block, entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace ps
