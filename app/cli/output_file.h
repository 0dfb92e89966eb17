#pragma once
#include <string>

namespace ps::cli {

/// Whether a picture is wanted (png, ppm, pfm) or any file.
enum class OutputKind { picture, any };

/// Throws InputError unless the file's folder exists and, for pictures, its extension is one that can be written; to be
/// called before long work, not after it.
void require_output_file(const std::string& path, OutputKind kind);

/// ".png" for "A.PNG".
std::string lower_extension(const std::string& path);

}  // namespace ps::cli
