// Every construct of the notation of formulas as the window sets it, against kept pictures: Debian 12 has Inter 4.0,
// Debian 13 has Inter 4.1, whose lines are a little closer. Where the page should look different, look at
// build/test-output/gui-maths-specimen-*/*.png and copy them to tests/gui/reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace maths_specimen_test {
namespace {

using Picture = ps::Image<ps::Rgb8>;

// Smoothing of slanted lines may differ between drivers by a few levels; ink in another place differs by more.
constexpr int moved_level = 64;

struct Page {
  std::string name, size, arguments, commands;
};

Picture crop(const Picture& picture, int x0, int y0, int width, int height) {
  Picture part(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) part.at(x, y) = picture.at(x0 + x, y0 + y);
  return part;
}

int moved_pixels(const Picture& a, const Picture& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const ps::Rgb8 p = a.at(x, y), q = b.at(x, y);
      count += std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) > moved_level ? 1 : 0;
    }
  return count;
}

/// The specimen as this page shows it, without the controls beside it.
Picture shown(const Page& page) {
  const auto folder = ps::fresh_output_folder("gui-maths-specimen-" + page.name);
  const std::string shot = (folder / "window.png").string();
  const auto result = ps::test::play("wait idle\n" + page.commands +
                                         "click tabs/maths\nwait idle\nmove tabs/options\nwait idle\n"
                                         "print specimen\nscreenshot " +
                                         shot + "\n",
                                     folder, page.size, "--widget-gallery " + page.arguments);
  EXPECT_EQ(result.status, 0) << result.errors;
  std::istringstream place(result.output);
  float x = 0, y = 0, width = 0, height = 0;
  EXPECT_TRUE(place >> x >> y >> width >> height) << result.output;
  const Picture window = ps::load_levels(shot);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  EXPECT_LE(y0 + static_cast<int>(height), window.height()) << "the page does not fit";
  Picture part = crop(window, x0, y0, std::min(static_cast<int>(width), window.width() - x0),
                      std::min(static_cast<int>(height), window.height() - y0));
  ps::save_image(folder / (page.name + ".png"), part);
  return part;
}

class MathsSpecimen : public testing::TestWithParam<Page> {};

TEST_P(MathsSpecimen, LooksAsItDid) {
  const Picture now = shown(GetParam());
  std::vector<int> moved;
  for (const char* release : {"", "-debian13"}) {
    const Picture kept = ps::load_levels("tests/gui/reference/maths-" + GetParam().name + release + ".png");
    if (kept.width() == now.width() && kept.height() == now.height()) moved.push_back(moved_pixels(now, kept));
  }
  ASSERT_FALSE(moved.empty()) << "the page has another size";
  EXPECT_EQ(*std::min_element(moved.begin(), moved.end()), 0) << GetParam().name;
}

std::string page_name(const testing::TestParamInfo<Page>& tested) { return tested.param.name; }

INSTANTIATE_TEST_SUITE_P(
    Window, MathsSpecimen,
    testing::Values(Page{"light", "1366x900", "--scale 1", ""}, Page{"large", "1900x1190", "--scale 1.5", ""},
                    Page{"dark", "1366x900", "--scale 1", "click menu/view\nclick menu/dark-theme\nwait idle\n"}),
    page_name);

/// Ink that touches no edge of the picture: a script or another small sign that stands alone.
bool holds_a_sign(const Picture& part) {
  int dark = 0;
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x) {
      const bool edge = x == 0 || y == 0 || x + 1 == part.width() || y + 1 == part.height();
      if (edge && part.at(x, y).g < 200) return false;
      dark += part.at(x, y).g < 100 ? 1 : 0;
    }
  return dark >= 12;
}

/// The comparison sees a single script that moves by one pixel.
TEST(MathsSpecimenComparison, SeesASmallSignMoveByOnePixel) {
  const Picture kept = ps::load_levels("tests/gui/reference/maths-light.png");
  constexpr int tile = 14;
  int signs = 0, seen = 0;
  for (int y = 0; y + tile < kept.height(); y += 4)
    for (int x = 0; x + tile < kept.width(); x += 4) {
      const Picture part = crop(kept, x, y, tile, tile);
      if (!holds_a_sign(part)) continue;
      ++signs;
      const bool down = moved_pixels(part, crop(kept, x, y + 1, tile, tile)) > 0;
      const bool right = moved_pixels(part, crop(kept, x + 1, y, tile, tile)) > 0;
      seen += down && right ? 1 : 0;
    }
  EXPECT_GT(signs, 20);
  EXPECT_EQ(seen, signs);
}

}  // namespace
}  // namespace maths_specimen_test
