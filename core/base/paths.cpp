#include "base/paths.h"

#include <cstdlib>

namespace ps {
namespace {

std::filesystem::path under_root(const char* name, const char* built_in) {
  const char* root = std::getenv("PIXELSCOPE_ROOT");
  if (root == nullptr || *root == '\0') return built_in;
  return std::filesystem::path(root) / name;
}

}  // namespace

std::filesystem::path asset_dir() { return under_root("assets", PIXELSCOPE_ASSET_DIR); }
std::filesystem::path chapter_dir() { return under_root("chapters", PIXELSCOPE_CHAPTER_DIR); }
std::filesystem::path font_dir() { return PIXELSCOPE_FONT_DIR; }

}  // namespace ps
