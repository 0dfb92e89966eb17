#pragma once
#include <string>
#include <string_view>

namespace ps {

/// The facts in the segments of a JPEG file.
struct JpegInfo {
  std::string_view bytes;  ///< up to the end of the picture, or of the file
  bool ended = true;       ///< false: the end marker is missing, but each component has a scan
  int orientation = 1;     ///< EXIF: 1 to 8, 1 = as stored
};

/// Walks over the segments of a JPEG file: each has its whole length, Huffman tables hold at most 256 codes (the
/// decoder does not look), and the picture is ended. Decoders fill what is missing at the end with anything: where only
/// the end marker is missing, the caller finds out whether pixels are too. Throws InputError that names `file`.
JpegInfo check_jpeg(std::string_view bytes, const std::string& file);

}  // namespace ps
