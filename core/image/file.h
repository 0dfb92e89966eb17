#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "image/read_limit.h"
#include "image/stored_picture.h"
#include "math/vec.h"

namespace ps {

struct LoadOptions {
  std::int64_t most_pixels = max_read_pixels;  ///< larger pictures are refused before they are decoded
};

/// Reads a picture of PNG, JPEG, TGA, PPM, PGM or PFM. The content decides which; a name of another format is noted.
/// Integer samples become value / largest value as stored (none is linearised), PFM floats stay as they are, grey is
/// copied to all three channels. Noted, and not applied: an EXIF orientation, the scale of a PFM file. A PNG or a JPEG
/// of one scan for each channel whose end is missing is read, with a note, if all of its pixels are there. Throws
/// InputError, naming the file and what is wrong with it, for a missing, truncated or corrupt file, an unknown format
/// and a size outside 1..most_pixels.
StoredPicture load_picture(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same for the bytes of a file at hand; the name is in messages.
StoredPicture decode_picture(std::string_view bytes, const std::filesystem::path& name,
                             const LoadOptions& options = {});

/// The colours alone.
Image<Vec3f> load_image(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same for a file of which only the 8-bit levels are wanted; out-of-range floats are clamped.
Image<Rgb8> load_levels(const std::filesystem::path& path);

/// A text kept inside a picture file, such as a permalink.
struct ImageText {
  std::string key;    ///< 1..79 printable ASCII characters
  std::string value;  ///< UTF-8 without NUL
  bool operator==(const ImageText&) const = default;
};

enum class PnmForm { binary, ascii };

struct SaveOptions {
  std::vector<ImageText> texts;  ///< PNG: text chunks; PPM: comments ("# key: value")
  PnmForm pnm = PnmForm::binary;
};

/// Writes a picture, replacing the file only when all is written; the extension names the format: png or ppm. Throws
/// InputError for an unknown extension and a folder that does not exist.
void save_image(const std::filesystem::path& path, const Image<Rgb8>& levels, const SaveOptions& options = {});

/// Writes floats without loss (Portable Float Map, little-endian); the extension must be pfm.
void save_pfm(const std::filesystem::path& path, const Image<Vec3f>& linear);
void save_pfm(const std::filesystem::path& path, const Image<float>& numbers);

/// The texts kept in a PNG file, in the file's order; empty for other formats.
std::vector<ImageText> load_texts(const std::filesystem::path& path);

}  // namespace ps
