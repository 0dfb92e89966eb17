// Pixels that are not a number are hatched in magenta and black, which no palette of the window and no sphere has.
#include <gtest/gtest.h>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace {

/// Pixels of a picture that are pure magenta.
int magenta_pixels(const std::filesystem::path& path) {
  int count = 0;
  for (const ps::Rgb8& pixel : ps::load_levels(path).pixels()) count += pixel == ps::Rgb8{255, 0, 255} ? 1 : 0;
  return count;
}

TEST(NanHatch, CoversThePixelsThatAreNotANumber) {
  const auto folder = ps::fresh_output_folder("gui-nan-hatch");
  const std::string scene = (folder / "nan.scene").string(), shot = (folder / "nan.png").string(),
                    sound = (folder / "sound.png").string();
  const auto result =
      ps::test::play("write " + scene +
                         " \"sphere { center = (0, 0, 3) radius = 1 color = (255, 0, 0) }\\nlight { type = point "
                         "intensity = 1 position = (0, 0, 0) attenuation = (1e-50, 0, 0) }\\n\"\n"
                         "open " +
                         scene + "\nwait idle\nscreenshot " + shot +
                         "\nset precision=double\nset-b precision=double\nwait idle\nscreenshot " + sound + "\nquit\n",
                     folder, "1024x768");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_GT(magenta_pixels(shot), 5000);  // the discs of A and B, less the black lines
  EXPECT_EQ(magenta_pixels(sound), 0);
}

}  // namespace
