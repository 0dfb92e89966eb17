#pragma once
#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace ps {

/// The scene as a text that parse_scene reads back as the same scene, for a file in `folder`: names of other files in
/// it are relative to that folder. Included files become part of it; models and textures from files stay references.
/// Materials, models and objects with equal names get numbers. Throws InputError for a texture that exists only in
/// memory.
std::string write_scene(const Scene& scene, const std::filesystem::path& folder);

/// Writes that text to a file, replacing an existing one only when all is written. Throws InputError.
void save_scene(const Scene& scene, const std::filesystem::path& path);

}  // namespace ps
