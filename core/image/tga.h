#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "image/stored_picture.h"

namespace ps {

/// Reads the bytes of a TGA file (Truevision TGA 2.0, 1991): grey, true colour or a palette, plain or run-length
/// encoded, from any of the four corners. 5-bit samples become value / 31. Opacity is read where the header names its
/// bits; a fourth byte that it does not name counts too, unless it is 0 in all pixels. Throws InputError that names
/// `file`.
StoredPicture read_tga(std::string_view bytes, const std::string& file, std::int64_t most_pixels);

/// Whether the bytes have a valid header and are as many as its pixels need at least.
bool is_tga(std::string_view bytes);

}  // namespace ps
