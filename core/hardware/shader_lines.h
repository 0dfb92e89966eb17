#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/shader_files.h"
#include "record/shader_listing.h"

namespace ps::hardware {

/// Values of uniforms as text, by their names.
using UniformTexts = std::map<std::string, std::string, std::less<>>;

/// The file of a shader and those that it includes, as the compiler sees them with these definitions ("#define LIGHTS
/// 3\n"): which lines it compiles, what the names in its conditions are, and beside the declarations the values of
/// uniforms. Throws InputError for a file that cannot be read and a condition that is none.
std::vector<ShaderFile> shader_lines(ShaderFiles& files, const std::string& name, std::string_view definitions,
                                     const UniformTexts& uniforms);

}  // namespace ps::hardware
