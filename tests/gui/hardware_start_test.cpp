// The hardware renderer's driver starts when a picture or the list of renderers asks for it, not with the program.
#include <gtest/gtest.h>

#include "gui/program.h"
#include "gui/remembering_window.h"
#include "support/golden.h"
#include "support/option_contexts.h"

namespace ps::gui::hardware_start_test {
namespace {

void expect_plays(const std::string& name, const std::string& commands, const std::string& arguments) {
  const auto folder = std::filesystem::absolute(fresh_output_folder("gui-hardware-start-" + name));
  const auto result = test::play(commands, folder, "1366x768", arguments);
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
}

TEST(HardwareStart, TheDriverWaitsForAPictureOrTheListOfRenderers) {
  if (!test::has_renderer("hardware")) GTEST_SKIP() << "this build has no hardware renderer";
  // Options that cannot act have buttons that set what wakes them, the renderer among it.
  const std::string plain =
      "wait idle\nexpect started/hardware no\nset renderer=rasterizer\nset multisampling=4\nwait idle\n"
      "click-pixel A 30,30\nwait idle\nset renderer=ray-tracer\nwait idle\nexpect started/hardware no\n";
  expect_plays("picture", plain + "set renderer=hardware\nwait idle\nexpect started/hardware yes\nquit\n",
               test::small_scene);
  expect_plays("list", plain + "click options/a/renderer\nwait idle\nexpect started/hardware yes\nquit\n",
               test::small_scene);
}

}  // namespace
}  // namespace ps::gui::hardware_start_test
