#pragma once
#include <cstdint>
#include <string>

#include "math/vec.h"

namespace ps {

/// Most memory that the pixels of a picture may take once it is read, in bytes: a file of some KiB can hold any number
/// of them, and textures need about three times as much again while they are drawn.
inline constexpr std::int64_t max_read_bytes = std::int64_t{768} << 20;
/// The same as a number of pixels: 8192 x 8192.
inline constexpr std::int64_t max_read_pixels = max_read_bytes / static_cast<std::int64_t>(sizeof(Vec3f));

/// Throws InputError, naming `file`, unless width and height are at least 1 and width * height is at most
/// `most_pixels`.
void require_read_size(std::int64_t width, std::int64_t height, std::int64_t most_pixels, const std::string& file);

}  // namespace ps
