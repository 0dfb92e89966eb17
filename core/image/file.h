#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "image/read_limit.h"
#include "math/vec.h"

namespace ps {

struct LoadOptions {
  std::int64_t most_pixels = max_read_pixels;  ///< larger pictures are refused before they are decoded
};

/// Reads a picture; the extension names the format: png jpg jpeg tga ppm pgm pnm pfm. Integer samples become
/// value / largest value as stored (nothing is linearised), PFM floats stay as they are, grey is copied to all three
/// channels, alpha is dropped. Throws InputError, naming the file and what is wrong with it, for a missing, truncated
/// or corrupt file, an unknown extension and a size outside 1..most_pixels.
Image<Vec3f> load_image(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same for the bytes of a file at hand; the name gives the format and is in messages.
Image<Vec3f> decode_image(std::string_view bytes, const std::filesystem::path& name, const LoadOptions& options = {});

/// The opacity of each pixel of a picture that load_image can read, in all three channels: 1 where the file has none.
Image<Vec3f> load_alpha(const std::filesystem::path& path, const LoadOptions& options = {});

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
