// Pixels that are not a number are hatched in magenta and black, which no palette of the window and no sphere has.
#include <gtest/gtest.h>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace nan_hatch_test {
namespace {

/// Pixels of a picture that are pure magenta.
int magenta_pixels(const std::filesystem::path& path) {
  int count = 0;
  const auto levels = ps::load_levels(path);
  for (const ps::Rgb8& pixel : levels.pixels()) count += pixel == ps::Rgb8{255, 0, 255} ? 1 : 0;
  return count;
}

TEST(NanHatch, CoversThePixelsThatAreNotANumber) {
  const auto folder = ps::fresh_output_folder("gui-nan-hatch");
  const std::string scene = (folder / "nan.scene").string(), shot = (folder / "nan.png").string(),
                    sound = (folder / "sound.png").string();
  const std::string picture = std::filesystem::absolute("tests/corpus/pfm/special.pfm").string();
  const auto result =
      ps::test::play("write " + scene + " \"texture { name = nan file = \\\"" + picture +
                         "\\\" }\\nsphere { center = (0, 0, 3) radius = 1 texture = nan }\\n"
                         "light { type = ambient intensity = 1 }\\n\"\nopen " +
                         scene + "\nwait idle\nscreenshot " + shot +
                         "\nset textures=off\nset-b textures=off\nwait idle\nscreenshot " + sound + "\nquit\n",
                     folder, "1024x768");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_GT(magenta_pixels(shot), 5000);  // the discs of A and B, less the black lines
  EXPECT_EQ(magenta_pixels(sound), 0);
}

}  // namespace
}  // namespace nan_hatch_test
