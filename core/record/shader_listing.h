#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "frame/frame.h"

namespace ps {

/// The two shaders of a draw call.
enum class ShaderPart { vertex, fragment };

/// A value that a line of a shader names: a uniform's, or a definition's.
struct ShaderValue {
  std::string name, value;
};

struct ShaderLine {
  std::string text;
  int number = 0;        ///< in its file, from 1
  bool compiled = true;  ///< false: its #if leaves it out of this program
  std::vector<ShaderValue> values;
};

struct ShaderFile {
  std::string name;  ///< "fragment.glsl"
  std::vector<ShaderLine> lines;
};

/// A draw call that the picked pixel is part of.
struct ShaderDraw {
  std::string pass;  ///< "light 2"; empty: the picture has no other pass
  PixelId id;        ///< the triangle; none where the whole picture is shaded at once
  /// By ShaderPart: the file with main() first, then those that it includes, in the order in which they are compiled.
  std::array<std::vector<ShaderFile>, 2> files;
};

/// The shaders that drew a pixel, with what the driver had for their uniforms.
struct ShaderListing {
  std::vector<ShaderDraw> draws;               ///< in drawing order; empty: nothing was drawn there
  std::vector<std::filesystem::path> watched;  ///< the files on disk that reload_shaders() reads
};

}  // namespace ps
