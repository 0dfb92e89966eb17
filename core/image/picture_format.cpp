#include "image/picture_format.h"

#include <array>

#include "base/extension.h"
#include "image/tga.h"

namespace ps {
namespace {

struct NamedFormat {
  std::string_view extension;
  PictureFormat format;
};

constexpr std::array<NamedFormat, 8> named_formats{{{".png", PictureFormat::png},
                                                    {".jpg", PictureFormat::jpeg},
                                                    {".jpeg", PictureFormat::jpeg},
                                                    {".tga", PictureFormat::tga},
                                                    {".ppm", PictureFormat::pnm},
                                                    {".pgm", PictureFormat::pnm},
                                                    {".pnm", PictureFormat::pnm},
                                                    {".pfm", PictureFormat::pfm}}};

/// "P6" or "PF", and white space or a comment behind it.
std::optional<PictureFormat> portable_map(std::string_view bytes) {
  constexpr std::string_view behind = " \t\r\n\v\f#";
  if (bytes.size() < 3 || bytes[0] != 'P' || behind.find(bytes[2]) == std::string_view::npos) return {};
  if (bytes[1] == 'F' || bytes[1] == 'f') return PictureFormat::pfm;
  return bytes[1] >= '1' && bytes[1] <= '6' ? std::optional(PictureFormat::pnm) : std::nullopt;
}

}  // namespace

std::string_view format_name(PictureFormat format) {
  switch (format) {
  case PictureFormat::png:
    return "PNG";
  case PictureFormat::jpeg:
    return "JPEG";
  case PictureFormat::tga:
    return "TGA";
  case PictureFormat::pnm:
    return "PNM";
  case PictureFormat::pfm:
    return "PFM";
  }
  return "";
}

std::optional<PictureFormat> format_by_name(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const NamedFormat& named : named_formats)
    if (named.extension == extension) return named.format;
  return {};
}

std::optional<PictureFormat> format_by_content(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return PictureFormat::png;
  if (bytes.starts_with("\xff\xd8\xff")) return PictureFormat::jpeg;
  if (const auto portable = portable_map(bytes)) return portable;
  return is_tga(bytes) ? std::optional(PictureFormat::tga) : std::nullopt;
}

}  // namespace ps
