#pragma once
#include <string>
#include <string_view>

#include "image/stored_picture.h"

namespace ps {

/// The only door to stb_image and stb_image_write.

/// Decodes PNG or JPEG bytes; colours are in [0, 1]. `file` is for messages. Throws InputError, also for more than
/// `most_pixels`; memory is bounded by the size that the header gives.
StoredPicture stb_decode(std::string_view bytes, const std::string& file, std::int64_t most_pixels);

/// The bytes of an 8-bit RGB PNG file.
std::string stb_encode_png(const Image<Rgb8>& levels);

}  // namespace ps
