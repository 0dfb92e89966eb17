#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "hardware/context.h"
#include "hardware/shader_files.h"

namespace ps::hardware {

enum class ShaderStage { vertex, fragment };

/// The text of a shader as the driver compiles it, and the files that its lines come from.
struct ShaderText {
  std::string text;
  std::vector<std::string> files;  ///< by the number that #line gives them
};

/// The text of a shader file ("fragment.glsl") and the files that it includes, and puts before them the head of
/// GLSL 3.30 or ES 3.00 and the definitions ("#define LIGHTS 3\n"). Throws InputError for a missing file, and for one
/// that includes itself, directly or by way of others.
ShaderText shader_text(ShaderFiles& files, std::string_view file, ShaderStage stage, Api api,
                       std::string_view definitions);

/// Numbers that all files compare their definitions with, as lines "#define PHONG 1".
std::string_view shader_constants();

/// What a driver says of a text that it does not compile, first line. Its place is "lighting.glsl:15", however the
/// driver writes it, with a column behind it where the driver gives one: "lighting.glsl:15(7): error: ...".
std::string compiler_words(const ShaderText& shader, std::string_view log);

}  // namespace ps::hardware
