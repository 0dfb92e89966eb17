#include "image/file.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/extension.h"
#include "image/codec.h"
#include "image/display.h"
#include "image/jpeg_check.h"
#include "image/picture_format.h"
#include "image/png_chunks.h"
#include "image/pnm.h"
#include "image/tga.h"

namespace ps {
namespace {

constexpr std::string_view known_extensions = "png, jpg, jpeg, tga, ppm, pgm, pnm or pfm";

[[noreturn]] void fail_extension(const std::filesystem::path& path, std::string_view expected) {
  throw InputError(
      fmt::format("{}: found the extension \"{}\", expected {}", path.string(), path.extension().string(), expected));
}

/// A palette index beyond the palette shows as whatever lies there: two paddings then give two pictures.
StoredPicture decode_palette_png(std::string_view bytes, const std::string& file, std::int64_t most) {
  StoredPicture picture = stb_decode(png_with_padded_palette(bytes, 0), file, most);
  if (picture != stb_decode(png_with_padded_palette(bytes, 255), file, most))
    throw InputError(fmt::format("{}: a pixel's palette index lies beyond the palette", file));
  return picture;
}

/// Decodes a file whose end is missing with two ends: where the pictures differ, pixels are missing too.
template <class Decode>
StoredPicture decode_without_end(const std::string& one_end, const std::string& other_end, const std::string& cut,
                                 Decode decode) {
  StoredPicture picture;
  try {
    picture = decode(one_end);
    if (picture != decode(other_end)) throw InputError(cut);
  } catch (const InputError&) {
    throw InputError(cut);
  }
  return picture;
}

void note_orientation(int orientation, StoredPicture& picture) {
  if (orientation != 1)
    picture.notes.push_back(fmt::format("has the EXIF orientation {}, which is not applied", orientation));
}

StoredPicture decode_png(std::string_view bytes, const std::string& file, std::int64_t most) {
  const PngInfo info = check_png(bytes, file);
  const bool palette = info.palette_entries > 0 && info.palette_entries < 1 << info.bit_depth && info.colour_type == 3;
  const auto decode = [&](std::string_view png) {
    return palette ? decode_palette_png(png, file, most) : stb_decode(png, file, most);
  };
  const std::string_view whole = bytes.substr(0, info.end);
  StoredPicture picture =
      info.ended
          ? decode(bytes)
          : decode_without_end(png_with_end(whole, 0), png_with_end(whole, 255),
                               fmt::format("{}: PNG is cut off at byte {}: no IEND chunk", file, bytes.size()), decode);
  if (!info.ended) picture.notes.emplace_back("ends without an IEND chunk, but has all of its pixels");
  note_orientation(info.orientation, picture);
  return picture;
}

StoredPicture decode_jpeg(std::string_view bytes, const std::string& file, std::int64_t most) {
  const JpegInfo info = check_jpeg(bytes, file);
  const auto decode = [&](std::string_view jpeg) { return stb_decode(jpeg, file, most); };
  const auto with_end = [&](char filler) {
    constexpr std::size_t further = 64;
    return std::string(info.bytes) + std::string(further, filler) + "\xff\xd9";
  };
  StoredPicture picture =
      info.ended ? decode(info.bytes)
                 : decode_without_end(with_end('\0'), with_end('\xaa'),
                                      fmt::format("{}: JPEG is cut off at byte {}: no end marker", file, bytes.size()),
                                      decode);
  if (!info.ended) picture.notes.emplace_back("ends without an end marker, but has all of its pixels");
  note_orientation(info.orientation, picture);
  return picture;
}

StoredPicture decode_as(PictureFormat format, std::string_view bytes, const std::string& file, std::int64_t most) {
  switch (format) {
  case PictureFormat::png:
    return decode_png(bytes, file, most);
  case PictureFormat::jpeg:
    return decode_jpeg(bytes, file, most);
  case PictureFormat::tga:
    return read_tga(bytes, file, most);
  case PictureFormat::pnm:
    return {read_pnm(bytes, file, most), {}, {}};
  case PictureFormat::pfm:
    return read_pfm(bytes, file, most);
  }
  return {};
}

template <class Pixel>
void save_floats(const std::filesystem::path& path, const Image<Pixel>& image) {
  PS_ASSERT(!image.empty(), "a picture to save has pixels");
  if (lower_extension(path) != ".pfm") fail_extension(path, "pfm");
  write_file_atomically(path, pfm_bytes(image));
}

}  // namespace

StoredPicture load_picture(const std::filesystem::path& path, const LoadOptions& options) {
  return decode_picture(read_whole_file(path), path, options);
}

StoredPicture decode_picture(std::string_view bytes, const std::filesystem::path& name, const LoadOptions& options) {
  const std::string file = name.string();
  if (bytes.empty()) throw InputError(fmt::format("{}: the file is empty, expected a picture", file));
  const auto named = format_by_name(name), found = format_by_content(bytes);
  if (!named && !found) fail_extension(name, known_extensions);
  StoredPicture picture = decode_as(found ? *found : *named, bytes, file, options.most_pixels);
  if (found && found != named)
    picture.notes.push_back(fmt::format("is read as {}, as its content says", format_name(*found)));
  return picture;
}

Image<Vec3f> load_image(const std::filesystem::path& path, const LoadOptions& options) {
  return load_picture(path, options).colour;
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
  const std::string bytes = read_whole_file(path);
  if (format_by_content(bytes) != PictureFormat::png) return {};
  return check_png(bytes, path.string()).texts;
}

}  // namespace ps
