#include "base/resources.h"

#include <cstdlib>
#include <string>

namespace ps {
namespace {

constexpr std::string_view chapters_in_project = "chapters/";

std::filesystem::path under_root(const char* name, const char* built_in) {
  const char* root = std::getenv("PIXELSCOPE_ROOT");
  if (root == nullptr || *root == '\0') return built_in;
  return std::filesystem::path(root) / name;
}

}  // namespace

std::filesystem::path asset_dir() { return under_root("assets", PIXELSCOPE_ASSET_DIR); }
std::filesystem::path scene_dir() { return asset_dir() / "scenes"; }

std::filesystem::path chapter_dir() { return under_root("chapters", PIXELSCOPE_CHAPTER_DIR); }
std::filesystem::path course_file() { return chapter_dir() / "course.md"; }
std::filesystem::path lesson_file(std::string_view folder) { return chapter_dir() / folder / "lesson.md"; }
std::filesystem::path glossary_file() { return chapter_dir() / "glossary.md"; }
std::filesystem::path listing_file(std::string_view folder) { return chapter_dir() / folder / "listing.cpp"; }
std::filesystem::path listing_bug_file(std::string_view folder, std::string_view bug) {
  return chapter_dir() / folder / "bugs" / (std::string(bug) + ".bug");
}

std::string portable_name(const std::string& name) {
  const std::string folder = chapter_dir().string() + "/";
  return name.starts_with(folder) ? std::string(chapters_in_project) + name.substr(folder.size()) : name;
}

std::string local_name(std::string_view text) {
  if (!text.starts_with(chapters_in_project)) return std::string(text);
  std::error_code error;
  const std::filesystem::path file = chapter_dir() / text.substr(chapters_in_project.size());
  return std::filesystem::is_regular_file(file, error) ? file.string() : std::string(text);
}

std::filesystem::path shader_file(std::string_view name) {
  return under_root("core/hardware/shaders", PIXELSCOPE_SHADER_DIR) / name;
}

std::filesystem::path header_dir() { return under_root("core", PIXELSCOPE_CORE_DIR); }
std::filesystem::path listing_library() {
  return std::filesystem::path(PIXELSCOPE_BUILD_DIR) / "lib/libpixelscope_listing.a";
}
std::filesystem::path launcher_program() {
  return std::filesystem::path(PIXELSCOPE_BUILD_DIR) / "bin/pixelscope-launch";
}

std::filesystem::path font_file(std::string_view name) { return std::filesystem::path(PIXELSCOPE_FONT_DIR) / name; }

}  // namespace ps
