#pragma once
#include <string>

namespace ps::cli {

/// What a file is to hold: display levels (png, ppm), these or floats (png, ppm, pfm), or anything.
enum class OutputKind { levels, picture, any };

/// Throws InputError unless the file can be written (see output_target()) and, for pictures, its extension is one that
/// can hold it; to be called before long work, not after it.
void require_output_file(const std::string& path, OutputKind kind);

/// ".png" for "A.PNG".
std::string lower_extension(const std::string& path);

}  // namespace ps::cli
