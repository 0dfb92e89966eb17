#pragma once
#include <map>
#include <string>

namespace ps::hardware {

/// The texts of the shader files. A file is read from disk when its text is first asked for, and stays as it was then:
/// programs that are made later fit those that are there.
class ShaderFiles {
 public:
  /// Of the file of this name ("fragment.glsl"). Throws InputError for a file that cannot be read.
  const std::string& text(const std::string& name);

 private:
  std::map<std::string, std::string> texts_;
};

}  // namespace ps::hardware
