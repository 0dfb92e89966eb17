#pragma once
#include <string>
#include <string_view>

namespace ps {

/// Decoders fill what is missing at the end of these files with anything, so that it is checked first. Both throw
/// InputError that names `file`.

/// Walks over the segments of a JPEG file: each has its whole length, Huffman tables hold at most 256 codes (the
/// decoder does not look), and the picture is ended. Returns the bytes up to that end.
std::string_view checked_jpeg(std::string_view bytes, const std::string& file);

/// A TGA file has a header and bytes enough for its pixels, as runs of 128 if it is run-length encoded.
void check_tga(std::string_view bytes, const std::string& file);

}  // namespace ps
