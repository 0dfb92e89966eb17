// Where the files that Pixelscope ships with lie. The folders are those of the source tree it was built from, unless
// the environment variable PIXELSCOPE_ROOT names another folder with assets/ and chapters/ in it.
#pragma once

#include <filesystem>

namespace ps {

std::filesystem::path asset_dir();
std::filesystem::path chapter_dir();
/// The fonts copied beside the programs; a font may be missing there.
std::filesystem::path font_dir();

}  // namespace ps
