#include "image/file.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "image/codec.h"
#include "image/display.h"
#include "image/jpeg_tga_check.h"
#include "image/png_chunks.h"
#include "image/pnm.h"

namespace ps {
namespace {

constexpr std::string_view known_extensions = "png, jpg, jpeg, tga, ppm, pgm, pnm or pfm";

enum class Format { png, jpeg, tga, pnm, pfm };

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::optional<Format> format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png") return Format::png;
  if (extension == ".jpg" || extension == ".jpeg") return Format::jpeg;
  if (extension == ".tga") return Format::tga;
  if (extension == ".ppm" || extension == ".pgm" || extension == ".pnm") return Format::pnm;
  if (extension == ".pfm") return Format::pfm;
  return {};
}

[[noreturn]] void fail_extension(const std::filesystem::path& path, std::string_view expected) {
  throw InputError(
      fmt::format("{}: found the extension \"{}\", expected {}", path.string(), path.extension().string(), expected));
}

/// A palette index beyond the palette shows as whatever lies there: two paddings then give two pictures.
Image<Vec3f> decode_palette_png(std::string_view bytes, const std::string& file, std::int64_t most) {
  Image<Vec3f> image = stb_decode(png_with_padded_palette(bytes, 0), file, most);
  if (image != stb_decode(png_with_padded_palette(bytes, 255), file, most))
    throw InputError(fmt::format("{}: a pixel's palette index lies beyond the palette", file));
  return image;
}

Image<Vec3f> decode_png(std::string_view bytes, const std::string& file, std::int64_t most) {
  const PngInfo info = check_png(bytes, file);
  if (info.palette_entries > 0 && info.palette_entries < 1 << info.bit_depth && info.colour_type == 3)
    return decode_palette_png(bytes, file, most);
  return stb_decode(bytes, file, most);
}

template <class Pixel>
void save_floats(const std::filesystem::path& path, const Image<Pixel>& image) {
  PS_ASSERT(!image.empty(), "a picture to save has pixels");
  if (lower_extension(path) != ".pfm") fail_extension(path, "pfm");
  write_file_atomically(path, pfm_bytes(image));
}

}  // namespace

Image<Vec3f> load_image(const std::filesystem::path& path, const LoadOptions& options) {
  if (!format_of(path)) fail_extension(path, known_extensions);
  return decode_image(read_whole_file(path), path, options);
}

Image<Vec3f> decode_image(std::string_view bytes, const std::filesystem::path& name, const LoadOptions& options) {
  const std::int64_t most = options.most_pixels;
  const auto format = format_of(name);
  if (!format) fail_extension(name, known_extensions);
  const std::string file = name.string();
  if (bytes.empty()) throw InputError(fmt::format("{}: the file is empty, expected a picture", file));
  switch (*format) {
  case Format::png:
    return decode_png(bytes, file, most);
  case Format::jpeg:
    return stb_decode(checked_jpeg(bytes, file), file, most);
  case Format::tga:
    check_tga(bytes, file);
    return stb_decode(bytes, file, most);
  case Format::pnm:
    return read_pnm(bytes, file, most);
  case Format::pfm:
    return read_pfm(bytes, file, most);
  }
  return {};
}

Image<Vec3f> load_alpha(const std::filesystem::path& path, const LoadOptions& options) {
  const auto format = format_of(path);
  if (!format) fail_extension(path, known_extensions);
  const std::string bytes = read_whole_file(path);
  const Image<Vec3f> colours = decode_image(bytes, path, options);  // all that can be wrong with the file
  if (format != Format::png && format != Format::tga) return {colours.width(), colours.height(), Vec3f(1)};
  const bool palette = format == Format::png && check_png(bytes, path.string()).palette_entries > 0;
  return stb_decode_alpha(palette ? png_with_padded_palette(bytes, 0) : bytes, path.string(), options.most_pixels);
}

Image<Rgb8> load_levels(const std::filesystem::path& path) { return display_image(load_image(path)); }

void save_image(const std::filesystem::path& path, const Image<Rgb8>& levels, const SaveOptions& options) {
  PS_ASSERT(!levels.empty(), "a picture to save has pixels");
  const std::string extension = lower_extension(path);
  if (extension == ".png") {
    write_file_atomically(path, png_with_texts(stb_encode_png(levels), options.texts));
  } else if (extension == ".ppm") {
    write_file_atomically(path, ppm_bytes(levels, options));
  } else {
    fail_extension(path, "png or ppm");
  }
}

void save_pfm(const std::filesystem::path& path, const Image<Vec3f>& linear) { save_floats(path, linear); }
void save_pfm(const std::filesystem::path& path, const Image<float>& numbers) { save_floats(path, numbers); }

std::vector<ImageText> load_texts(const std::filesystem::path& path) {
  if (format_of(path) != Format::png) return {};
  return check_png(read_whole_file(path), path.string()).texts;
}

}  // namespace ps
