#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ps {

/// The first program of these names in the folders of a search path ("/usr/bin:/bin"); empty if there is none.
std::filesystem::path find_program(const std::vector<std::string>& names, const std::string& search_path);

}  // namespace ps
