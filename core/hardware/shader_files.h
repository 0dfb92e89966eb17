#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ps::hardware {

/// The texts of the shader files. A file is read from disk when its text is first asked for, and stays as it was then:
/// programs that are made later fit those that are there.
class ShaderFiles {
 public:
  /// The text of the file of this name ("fragment.glsl"). Throws InputError for a file that cannot be read, and for a
  /// name that leads out of the folder of the shaders.
  const std::string& text(const std::string& name);
  /// The name in a line `#include "tints.glsl"`; nullopt for any other line.
  static std::optional<std::string> included_name(std::string_view line);

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace ps::hardware
