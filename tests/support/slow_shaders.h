#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include "base/resources.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace ps::test {

/// Programs that start while it lives have shaders that a graphics driver takes minutes to compile.
class SlowShaders {
 public:
  SlowShaders() : root_("PIXELSCOPE_ROOT", made()) {}

 private:
  std::string made() const {
    const std::filesystem::path root = folder_.path(), shaders = root / "core/hardware/shaders";
    std::filesystem::create_directories(shaders.parent_path());
    std::filesystem::copy(shader_file(""), shaders);
    std::filesystem::create_directory_symlink(asset_dir(), root / "assets");
    std::filesystem::create_directory_symlink(chapter_dir(), root / "chapters");
    // A product that doubles 25 times.
    std::string text = "#define T0(x) (x + 1.0)\n";
    for (int i = 1; i <= 25; ++i) {
      const std::string one = "T" + std::to_string(i - 1) + "(x)";
      text += "#define T" + std::to_string(i) + "(x) (" + one + " * " + one + ")\n";
    }
    std::ofstream(shaders / "tints.glsl", std::ios::app) << text << "float endless(float x) { return T25(x); }\n";
    return root.string();
  }

  ScratchFolder folder_;
  Variable root_;
};

}  // namespace ps::test
