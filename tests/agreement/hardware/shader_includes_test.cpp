// Shader files that include each other: in a circle they are refused with the place, once each they are read.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "hardware/shader_text.h"
#include "support/environment.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::shader_includes_test {
namespace {

class ShaderIncludes : public testing::Test {
 protected:
  ShaderIncludes() : root_("PIXELSCOPE_ROOT", folder_.path().string()) {
    std::filesystem::create_directories(folder_.path() / "core/hardware/shaders");
  }
  void write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_.path() / "core/hardware/shaders" / name, text);
  }
  /// What is said of the file.
  static std::string refusal(const std::string& name) {
    return test::refusal_of([&] {
      hardware::ShaderFiles files;
      hardware::shader_text(files, name, ShaderStage::fragment, hardware::Api::desktop, "");
    });
  }

  test::ScratchFolder folder_;
  test::Variable root_;
};

TEST_F(ShaderIncludes, OfAFileByItselfAreRefused) {
  write("a.glsl", "// first\n#include \"a.glsl\"\n");
  EXPECT_EQ(refusal("a.glsl"), "a.glsl:2: a.glsl includes itself");
}

TEST_F(ShaderIncludes, InACircleAreRefused) {
  write("a.glsl", "#include \"b.glsl\"\n");
  write("b.glsl", "#if 0\n#include \"a.glsl\"\n#endif\n");
  EXPECT_EQ(refusal("a.glsl"), "b.glsl:2: a.glsl includes itself, by way of b.glsl");
  constexpr int chain = 200;
  for (int i = 0; i < chain; ++i)
    write("c" + std::to_string(i) + ".glsl", "#include \"c" + std::to_string((i + 1) % chain) + ".glsl\"\n");
  EXPECT_EQ(refusal("c7.glsl"), "c6.glsl:1: c7.glsl includes itself, by way of c6.glsl");
}

TEST_F(ShaderIncludes, OfOneFileFromTwoAreNone) {
  write("a.glsl", "#include \"b.glsl\"\n#include \"c.glsl\"\n");
  write("b.glsl", "#include \"d.glsl\"\n");
  write("c.glsl", "#include \"d.glsl\"\n");
  write("d.glsl", "int shared_by_both;\n");
  EXPECT_EQ(refusal("a.glsl"), "");
}

TEST_F(ShaderIncludes, LeadNowhereElse) {
  write_file_atomically(folder_.path() / "secret", "outside\n");
  for (const char* name : {"../../../secret", "../shaders/a.glsl", "/etc/hostname", ".."}) {
    write("a.glsl", std::string("#include \"") + name + "\"\n");
    EXPECT_EQ(refusal("a.glsl"),
              std::string("\"") + name + "\": expected a name in the folder of the shaders, without '/'");
  }
}

}  // namespace
}  // namespace ps::shader_includes_test
