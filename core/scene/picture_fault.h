#pragma once
#include <filesystem>
#include <string>

#include "base/check.h"

namespace ps {

/// Why load_picture(path) refused the picture: the message of its error without the path that it begins with.
std::string picture_fault(const std::filesystem::path& path, const InputError& error);

}  // namespace ps
