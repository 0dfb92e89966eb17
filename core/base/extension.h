#pragma once
#include <filesystem>
#include <string>

namespace ps {

/// The extension of a file's name in small letters, with its dot: ".png"; empty where there is none.
std::string lower_extension(const std::filesystem::path& path);

}  // namespace ps
