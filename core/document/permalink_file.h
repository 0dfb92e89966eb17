#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "document/document.h"

namespace ps {

/// The extension of files that hold a permalink as their only line.
inline constexpr const char* permalink_extension = ".permalink";

/// Calls `change` for each value of a permalink that is a path of the user's, relative or not, and puts the result in
/// its place.
std::string with_paths(std::string_view link, const std::function<std::string(const std::string&)>& change);

/// The permalink that a file holds: the line of a .permalink file, that of a bundle (document/bundle.h), or the text
/// that pictures saved by the programs carry (PNG). nullopt for any other file, and for a picture without one. Relative
/// paths in it that lead nowhere from the working folder are looked for from the file's folder and those above it.
/// Throws InputError for a file that cannot be read.
std::optional<std::string> permalink_in_file(const std::filesystem::path& path);

/// The document's permalink for a file to hold it. Paths that permalink_in_file() would not find become absolute.
std::string permalink_for_file(const std::filesystem::path& path, const Document& document);

/// Writes the document's permalink as a file of one line. Throws InputError where it cannot be written.
void save_permalink(const std::filesystem::path& path, const Document& document);

}  // namespace ps
