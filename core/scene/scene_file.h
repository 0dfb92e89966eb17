#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace ps {

/// Reads a scene in the notation of CGFS (chapters 2 to 13, completed where the book only hints): assignments
/// `key = value` and blocks `sphere { ... }`, in any layout, with # comments.
/// `file` is the name for messages and Scene::name; other files are found relative to `folder`. Throws InputError with
/// file, line and column for anything that it does not understand: no part is ignored.
Scene parse_scene(std::string_view text, const std::string& file, const std::filesystem::path& folder);

/// Title, description and keywords alone, as cheaply as possible, for lists of scenes.
struct SceneHeading {
  std::string title;
  std::string description;
  std::string keywords;
};
SceneHeading parse_scene_heading(std::string_view text, const std::string& file);

/// The content of a text file of at most `max_bytes`. Throws InputError if it is missing, unreadable, not a regular
/// file, empty, or larger.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes);
inline constexpr std::uintmax_t max_scene_file_bytes = std::uintmax_t{32} << 20;

}  // namespace ps
