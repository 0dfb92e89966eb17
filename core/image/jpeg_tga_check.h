#pragma once
#include <string>
#include <string_view>

namespace ps {

/// Decoders fill what is missing at the end of these files with anything, so that it is checked first. Both throw
/// InputError that names `file`.

/// A JPEG file begins with its marker and its last scan is ended.
void check_jpeg(std::string_view bytes, const std::string& file);

/// A TGA file has a header and, unless it is run-length encoded, all of its pixels.
void check_tga(std::string_view bytes, const std::string& file);

}  // namespace ps
