#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "frame/frame.h"

namespace ps {

/// The two shaders of a draw call.
enum class ShaderStage { vertex, fragment };

/// The text of a shader as the driver gets it: `#version`, definitions, then the file with main() and, in the place of
/// each `#include`, the file that it names.
struct ShaderText {
  std::string text;
  std::vector<std::string> files;  ///< "fragment.glsl"; by the number that `#line` gives them in the text
};

/// The two shaders of a program.
using ShaderPair = std::array<ShaderText, 2>;
inline const ShaderText& text_of(const ShaderPair& pair, ShaderStage stage) {
  return pair[static_cast<std::size_t>(stage)];
}

/// A program that the picked pixel is drawn by.
struct ShaderDraw {
  std::string pass;  ///< "shading"; empty: the picture is drawn by one program
  PixelId id;        ///< the triangle; none where the whole picture is shaded at once
  ShaderPair shaders;
};

/// The shaders that drew a pixel.
struct ShaderListing {
  std::vector<ShaderDraw> draws;               ///< in drawing order; empty: none was drawn there
  std::vector<std::filesystem::path> watched;  ///< the files on disk that reload_shaders() reads
};

}  // namespace ps
