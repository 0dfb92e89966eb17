#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ps {

/// Throws InputError if writing to `output` would replace one of the files `inputs`, whatever path either is given by.
/// To be called before anything is written: a picture must not take the place of a texture that it was made with.
void require_no_input(const std::filesystem::path& output, const std::vector<std::string>& inputs);

}  // namespace ps
