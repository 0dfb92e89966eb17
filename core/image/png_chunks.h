#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "image/file.h"

namespace ps {

/// The facts that a PNG file stores about itself.
struct PngInfo {
  int width = 0, height = 0;
  int bit_depth = 0;
  int colour_type = 0;      ///< 0 grey, 2 RGB, 3 palette, 4 grey + alpha, 6 RGBA
  int palette_entries = 0;  ///< 0 without a palette
  int orientation = 1;      ///< EXIF: 1 to 8, 1 = as stored
  bool ended = true;        ///< false: the end is missing, from behind the picture data
  std::size_t end = 0;      ///< where the last whole chunk ends
  std::vector<ImageText> texts;
};

/// Checks all of a PNG file but its compressed data: signature, chunk lengths and CRCs, the header's values, the order
/// of the chunks that decide what is decoded, a picture of at most max_image_pixels, and an end. Only an end that is
/// cut off behind whole picture data is let through. Throws InputError that names `file` and what is wrong. Decoders
/// may skip all this, so it comes first.
PngInfo check_png(std::string_view bytes, const std::string& file);

/// Adds text chunks after the header of a valid PNG file: tEXt where the value is plain ASCII, else iTXt. Throws
/// InputError for a key that PNG does not allow.
std::string png_with_texts(std::string_view png, const std::vector<ImageText>& texts);

/// A PNG with a palette, its palette extended to 256 entries of one grey level; indices beyond the file's own palette
/// then show in the picture instead of reading beyond it.
std::string png_with_padded_palette(std::string_view png, std::uint8_t level);

/// The whole chunks of a PNG without an end, as picture data that go on with bytes of one value, and an end.
std::string png_with_end(std::string_view png, std::uint8_t filler);

/// CRC-32 of ISO 3309, as PNG uses it.
std::uint32_t crc32(std::string_view bytes);

}  // namespace ps
