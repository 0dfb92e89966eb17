#pragma once
#include <string>

#include "image/png_chunks.h"

namespace ps::fuzz {

/// Mends the CRCs of all chunks that still have a length within the file, so that damage reaches the decoder.
inline void mend_png(std::string& png) {
  const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(png[at])); };
  std::size_t at = 8;
  while (at + 12 <= png.size()) {
    const std::size_t length = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
    if (length > png.size() - at - 12) return;
    const std::uint32_t crc = crc32(std::string_view(png).substr(at + 4, 4 + length));
    for (std::size_t i = 0; i < 4; ++i) png[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xff);
    at += 12 + length;
  }
}

}  // namespace ps::fuzz
