#pragma once
#include <string>
#include <string_view>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// The only door to stb_image and stb_image_write.

/// Decodes PNG, JPEG or TGA bytes to values in [0, 1]. `file` is for messages. Throws InputError, also for more
/// than `most_pixels`; memory is bounded by the size that the header gives.
Image<Vec3f> stb_decode(std::string_view bytes, const std::string& file, std::int64_t most_pixels);

/// The same for the opacity of each pixel, in all three channels: 1 where the file has none.
Image<Vec3f> stb_decode_alpha(std::string_view bytes, const std::string& file, std::int64_t most_pixels);

/// The bytes of an 8-bit RGB PNG file.
std::string stb_encode_png(const Image<Rgb8>& levels);

}  // namespace ps
