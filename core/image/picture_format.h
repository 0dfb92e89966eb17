#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

namespace ps {

/// The formats of picture files that can be read.
enum class PictureFormat { png, jpeg, tga, pnm, pfm };

/// "PNG", for messages.
std::string_view format_name(PictureFormat format);

/// The format that a file's extension names; nullopt for an unknown one.
std::optional<PictureFormat> format_by_name(const std::filesystem::path& path);

/// The format of a file's bytes. TGA has no signature: it is what has a valid header and bytes enough for its pixels.
std::optional<PictureFormat> format_by_content(std::string_view bytes);

}  // namespace ps
