// The difference of two pictures calls them identical only if their values are, beyond what display levels show.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "gui/program.h"
#include "image/file.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/golden.h"

namespace ps::identical_test {
namespace {

TEST(Identical, TheWindowTellsValuesFromLevels) {
  const auto folder = fresh_output_folder("gui-identical");
  const std::string scene_file = (folder / "bright.scene").string();
  write_file_atomically(scene_file, "sphere { center = (0, 0, 3)  radius = 1  color = (255, 255, 255) }\n"
                                    "light { type = ambient  intensity = 3 }\n");
  const Scene scene = load_scene(scene_file);
  Image<Vec3f> values = render(scene, {scene.camera, 40, 30}, settings_for(scene)).colour;
  const auto bright = std::count_if(values.pixels().begin(), values.pixels().end(), [](Vec3f v) { return v.r == 3; });
  ASSERT_GT(bright, 20);
  save_pfm(folder / "same.pfm", values);
  for (Vec3f& value : values.pixels())
    value = Vec3f(std::min(value.r, 1.0f), std::min(value.g, 1.0f), std::min(value.b, 1.0f));
  save_pfm(folder / "clamped.pfm", values);
  std::filesystem::rename(folder / "clamped.pfm", folder / "clamped.png");  // the content decides
  const auto compare = [&](const char* file, const std::string& expected) {
    return "open " + (folder / file).string() + "\nwait idle\nexpect difference/notice \"" + expected +
           "\"\nscreenshot " + (folder / file).string() + "-shot.png\n";
  };
  const auto result = test::play(
      "wait idle\nkey D\nwait idle\n" + compare("same.pfm", "A and B are identical.") +
          compare("clamped.png", "A and B are identical in display levels. Their values differ by at most 2 in " +
                                     std::to_string(bright) + " pixels.") +
          "expect message contains \"clamped.png: is read as PFM, as its content says.\"\nquit\n",
      folder, "1024x768", scene_file + " --set renderer=ray-tracer");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
}

/// A white picture as TGA, whose first pixels are transparent.
std::string white_with_alpha(const Image<Vec3f>& values, std::size_t transparent) {
  std::string bytes{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  for (const int size : {values.width(), values.height()}) {
    bytes += static_cast<char>(size % 256);
    bytes += static_cast<char>(size / 256);
  }
  bytes += {32, 0x28};  // 8 bits of alpha, from the top
  for (std::size_t i = 0; i < values.pixels().size(); ++i)
    bytes += std::string(3, '\xff') + (i < transparent ? '\0' : '\xff');
  return bytes;
}

TEST(Identical, TheWindowTellsTheAlphaOfAFile) {
  const auto folder = fresh_output_folder("gui-identical-alpha");
  const std::string scene_file = (folder / "white.scene").string();
  write_file_atomically(scene_file, "sphere { center = (0, 0, 3)  radius = 1  color = (255, 255, 255) }\n"
                                    "light { type = ambient  intensity = 1 }\n");
  const Scene scene = load_scene(scene_file);
  const Image<Vec3f> values = render(scene, {scene.camera, 40, 30}, settings_for(scene)).colour;
  for (const Vec3f& value : values.pixels()) ASSERT_EQ(value, Vec3f(1)) << "the sphere and the background are white";
  write_file_atomically(folder / "alpha.tga", white_with_alpha(values, 123));
  const auto result =
      test::play("wait idle\nkey D\nwait idle\nopen " + (folder / "alpha.tga").string() +
                     "\nwait idle\nexpect difference/notice \"A and B are identical in colour. The alpha of B differs "
                     "from 1 by at most 1 in 123 pixels.\"\nscreenshot " +
                     (folder / "shot.png").string() + "\nquit\n",
                 folder, "1024x768", scene_file + " --set renderer=ray-tracer");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
}

}  // namespace
}  // namespace ps::identical_test
