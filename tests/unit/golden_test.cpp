#include "support/golden.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "image/file.h"

namespace golden_test {
namespace {

using ps::Image;
using ps::Rgb8;

TEST(ExpectMatches, AllowsNoMoreThanItsTolerance) {
  static Image<Rgb8> expected(8, 8, {100, 100, 100});
  static Image<Rgb8> actual;
  actual = expected;
  EXPECT_TRUE(ps::expect_matches("golden-self-test", actual, expected));
  actual.at(3, 5).g = 101;
  actual.at(6, 7).b = 98;
  EXPECT_TRUE(ps::expect_matches("golden-self-test", actual, expected, {.max_differing_pixels = 2, .max_level = 2}));
  EXPECT_NONFATAL_FAILURE(ps::expect_matches("golden-self-test", actual, expected),
                          "2 pixels differ (at most 0 may), by up to 2 levels (at most 255); the first is (3, 5)");
  EXPECT_NONFATAL_FAILURE(ps::expect_matches("golden-self-test", actual, expected, {.max_differing_pixels = 1}),
                          "2 pixels differ");
  EXPECT_NONFATAL_FAILURE(
      ps::expect_matches("golden-self-test", actual, expected, {.max_differing_pixels = 9, .max_level = 1}),
      "by up to 2 levels");
  EXPECT_NONFATAL_FAILURE(ps::expect_matches("golden-self-test", Image<Rgb8>(2, 2), expected), "found 2 x 2");
}

TEST(ExpectMatches, LeavesThePicturesForALook) {
  const auto folder = ps::fresh_output_folder("golden-look").parent_path();
  static Image<Rgb8> expected(4, 4, {10, 10, 10});
  static Image<Rgb8> actual(4, 4, {12, 10, 10});
  for (const char* part : {"expected", "actual", "difference"})
    std::filesystem::remove(folder / (std::string("golden-look-") + part + ".png"));
  EXPECT_NONFATAL_FAILURE(ps::expect_matches("golden-look", actual, expected), "16 pixels differ");
  EXPECT_EQ(ps::load_levels(folder / "golden-look-expected.png"), expected);
  EXPECT_EQ(ps::load_levels(folder / "golden-look-actual.png"), actual);
  EXPECT_EQ(ps::load_levels(folder / "golden-look-difference.png").at(0, 0), (Rgb8{64, 0, 0}));
}

TEST(ExpectMatches, ReadsReferences) {
  const auto picture = ps::load_levels(ps::reference_path("raster-03.png"));
  EXPECT_TRUE(ps::expect_matches("golden-reference", picture, ps::reference_path("raster-03.png")));
}

}  // namespace
}  // namespace golden_test
