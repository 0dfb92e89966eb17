#pragma once
#include <filesystem>
#include <string>

#include "document/document.h"

namespace ps {

/// Writes all that is on the screen into one archive for others: a permalink, and where scene, textures or B's picture
/// are files of the user's, those files with all that the scene reads, each where it lies beside the others. Throws
/// InputError where one of them cannot be read, or where the bundle cannot be written or is larger than
/// `largest_archive`.
void save_bundle(const std::filesystem::path& file, const Document& document);

/// The permalink of a bundle; its paths lead into the archive (base/archived_file.h), which is not unpacked. An archive
/// without a permalink shows its only .scene file, or else its only .obj file. Throws InputError for any other file.
std::string permalink_in_bundle(const std::filesystem::path& file);

}  // namespace ps
