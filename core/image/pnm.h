#pragma once
#include <string>
#include <string_view>

#include "image/file.h"

namespace ps {

/// Reads the bytes of a PGM or PPM file, ASCII (P2, P3) or binary (P5, P6), with comments and largest values up to
/// 65535; samples become value / largest value. Throws InputError naming `file` and the line, also for more
/// than `most_pixels`.
Image<Vec3f> read_pnm(std::string_view bytes, const std::string& file, std::int64_t most_pixels = max_read_pixels);

/// Reads the bytes of a Portable Float Map, colour (PF) or grey (Pf), of either byte order. The floats stay as they
/// are, NaN and infinity too. The sign of the scale in the header gives the byte order; its size is not applied, and
/// one other than 1 is noted. Throws InputError as read_pnm does.
StoredPicture read_pfm(std::string_view bytes, const std::string& file, std::int64_t most_pixels = max_read_pixels);

/// The bytes of a PPM file (P6, or P3 for ascii) with the texts as comments.
std::string ppm_bytes(const Image<Rgb8>& levels, const SaveOptions& options);

/// The bytes of a little-endian PFM file, of colour (PF) or of one number for each pixel (Pf).
std::string pfm_bytes(const Image<Vec3f>& linear);
std::string pfm_bytes(const Image<float>& numbers);

}  // namespace ps
