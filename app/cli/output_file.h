#pragma once
#include <filesystem>
#include <string>

namespace ps::cli {

/// The content of a file: display levels (png, ppm), these or floats (png, ppm, pfm), or anything.
enum class OutputKind { levels, picture, any };

/// Throws InputError unless the file can be written (see output_target()) and, for pictures, its extension is one that
/// can hold it; to be called before long work, not after it.
void require_output_file(const std::string& path, OutputKind kind);

/// Writes the text into the file `out`, or prints it if that is empty.
void write_result(const std::string& text, const std::string& out);

/// Makes the folder if it is missing. Throws InputError where that fails.
void make_folder(const std::filesystem::path& folder);

}  // namespace ps::cli
