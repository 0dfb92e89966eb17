#include "image/jpeg_tga_check.h"

#include <fmt/format.h>

#include "image/image.h"

namespace ps {

void check_jpeg(std::string_view bytes, const std::string& file) {
  constexpr std::string_view start("\xff\xd8", 2);
  constexpr std::string_view scan("\xff\xda", 2);
  constexpr std::string_view end("\xff\xd9", 2);
  if (bytes.substr(0, 2) != start)
    throw InputError(fmt::format("{}: found no JPEG signature, expected a JPEG file", file));
  const auto last_scan = bytes.rfind(scan);
  const auto last_end = bytes.rfind(end);
  if (last_scan == std::string_view::npos || last_end == std::string_view::npos || last_end < last_scan)
    throw InputError(fmt::format("{}: JPEG is cut off: no end marker after its last scan", file));
}

void check_tga(std::string_view bytes, const std::string& file) {
  constexpr std::size_t header_size = 18;
  if (bytes.size() < header_size)
    throw InputError(fmt::format("{}: TGA is cut off: found {} bytes, expected a header of 18", file, bytes.size()));
  const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])); };
  const auto word = [&](std::size_t at) { return byte(at) | byte(at + 1) << 8; };
  require_image_size(static_cast<std::int64_t>(word(12)), static_cast<std::int64_t>(word(14)), file);
  constexpr std::size_t rle = 8;
  const bool compressed = (byte(2) & rle) != 0;
  const std::size_t palette = byte(1) == 0 ? 0 : word(5) * ((byte(7) + 7) / 8);
  const std::size_t pixels = compressed ? 0 : word(12) * word(14) * ((byte(16) + 7) / 8);
  const std::size_t expected = header_size + byte(0) + palette + pixels;
  if (bytes.size() < expected)
    throw InputError(
        fmt::format("{}: TGA is cut off: found {} bytes, expected at least {}", file, bytes.size(), expected));
}

}  // namespace ps
