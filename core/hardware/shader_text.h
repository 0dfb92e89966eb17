#pragma once
#include <string>
#include <string_view>

#include "hardware/context.h"
#include "hardware/shader_files.h"
#include "record/shader_listing.h"

namespace ps::hardware {

/// The text of a shader file ("fragment.glsl") and the files that it includes, and puts before them the head of
/// GLSL 3.30 or ES 3.00 and the definitions ("#define LIGHTS 3\n"). Throws InputError for a missing file, and for one
/// that includes itself, directly or by way of others.
ShaderText shader_text(ShaderFiles& files, std::string_view file, ShaderStage stage, Api api,
                       std::string_view definitions);

/// The text with line numbers that encode the file as well as the line: once Mesa has parsed a shader, it no longer
/// knows the file that `#line` names, and reports every mistake as one of file 0.
std::string with_numbered_files(const ShaderText& shader);

/// What a driver says of a text with numbered files that it does not compile, first line. Its place is
/// "lighting.glsl:15", however the driver writes it, with a column behind it where the driver gives one:
/// "lighting.glsl:15(7): error: ...".
std::string compiler_words(const ShaderText& shader, std::string_view log);

}  // namespace ps::hardware
