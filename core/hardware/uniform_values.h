#pragma once
#include "hardware/program.h"
#include "hardware/shader_lines.h"

namespace ps::hardware {

/// What the driver holds for each uniform that the program in use reads: numbers with six digits, of a texture its unit
/// and its size, of an array in a block its first elements.
UniformTexts uniform_values(const Program& program);

}  // namespace ps::hardware
