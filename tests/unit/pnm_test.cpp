#include "image/pnm.h"

#include <gtest/gtest.h>

#include "image/display.h"
#include "support/refusal.h"

namespace pnm_test {
namespace {

using ps::Rgb8;
using ps::Vec3f;

std::string pnm_error(const std::string& bytes) {
  return ps::test::refusal_of([&] { ps::read_pnm(bytes, "a.ppm"); });
}

std::string pfm_error(const std::string& bytes) {
  return ps::test::refusal_of([&] { ps::read_pfm(bytes, "a.pfm"); });
}

TEST(Pnm, ReadsAllFourKinds) {
  const auto colour = ps::display_image(ps::read_pnm("P3 2 1 255 255 0 10  1 2 3", "a"));
  EXPECT_EQ(colour.at(0, 0), (Rgb8{255, 0, 10}));
  EXPECT_EQ(colour.at(1, 0), (Rgb8{1, 2, 3}));
  EXPECT_EQ(ps::read_pnm("P2\n1 2\n4\n1\n3\n", "a").at(0, 1), Vec3f(0.75f));
  EXPECT_EQ(ps::display_image(ps::read_pnm("P6 1 1 255\nabc", "a")).at(0, 0), (Rgb8{'a', 'b', 'c'}));
  EXPECT_EQ(ps::display_image(ps::read_pnm("P5 1 1 255 #", "a")).at(0, 0), (Rgb8{'#', '#', '#'}))
      << "data, not a comment";
  EXPECT_EQ(ps::read_pnm(std::string("P5 1 1 65535\n\x12\x34", 15), "a").at(0, 0), Vec3f(0x1234 / 65535.0f));
  EXPECT_EQ(ps::read_pnm("P5 1 1 255\n\nrest", "a").at(0, 0), Vec3f(10 / 255.0f)) << "one white-space character only";
}

TEST(Pnm, PassesOverComments) {
  const auto image = ps::read_pnm("P3 # kind\n# 9 9\n2 # width\r\n1#height\n255\n1 2 3 # one\n4 5 6", "a");
  ASSERT_EQ(image.width(), 2);
  ASSERT_EQ(image.height(), 1);
  EXPECT_EQ(ps::display_image(image).at(1, 0), (Rgb8{4, 5, 6}));
}

TEST(Pnm, ErrorsNameTheLineAndWhatIsWrong) {
  const auto expect = [](const std::string& bytes, const std::string& part) {
    EXPECT_NE(pnm_error(bytes).find(part), std::string::npos)
        << "found: " << pnm_error(bytes) << "\nexpected: " << part;
  };
  expect("", "a.ppm:1: found the end of the file");
  expect("P7 1 1 255", "P2, P3, P5 or P6");
  expect("P3\n-2 1\n255\n", "a.ppm:2: found '-2', expected width");
  expect("P3\n2 0\n255\n", "a.ppm:2: found '0', expected height");
  expect("P3\n2 1.5\n255\n", "'1.5'");
  expect("P3\n99999999999999999999 1\n255\n", "expected width");
  expect("P6\n2147483647 2147483647\n255\n", "2147483647 x 2147483647");
  expect("P6\n8192 8192\n255\nabc", "201326592");
  expect("P3\n8192 8192\n255\n1 2 3", "cut off");
  expect("P3\n1 1\n0\n0 0 0", "a.ppm:3: found '0', expected largest value");
  expect("P3\n1 1\n65536\n0 0 0", "'65536'");
  expect("P3\n1 1\n255\n1 2\n256", "a.ppm:5: found '256', expected sample");
  expect("P3\n1 1\n255\n1 2\nx", "a.ppm:5: found 'x'");
  expect("P3\n1 1\n255\n1 -2\n3", "'-2'");
  expect("P3\n2 1\n255\n11 21 31 41 51", "a.ppm:4: found the end of the file");
  expect("P6\n1 1\n255", "the end of the file");
  expect("P6\n1 1\n255\nab", "found 2 bytes of pixels, expected 3");
  expect("P5\n1 1\n100\nz", "found sample 122, expected at most 100");
}

TEST(Pnm, ACutAtAnyByteIsAnError) {
  for (const std::string& file : {std::string("P6 2 2 255\nabcdefghijkl"), std::string("P3 1 2 9\n1 2 3 4 5 6"),
                                  std::string("P5 2 2 300\nabcdefgh").replace(6, 3, "999")}) {
    for (std::size_t length = 0; length < file.size(); ++length)
      EXPECT_NE(pnm_error(file.substr(0, length)), "") << file.substr(0, length);
  }
  const std::string pfm("PF\n1 2\n-1\n" + std::string(24, '\0'));
  EXPECT_EQ(pfm_error(pfm), "");
  for (std::size_t length = 0; length < pfm.size(); ++length) EXPECT_NE(pfm_error(pfm.substr(0, length)), "") << length;
}

TEST(Pnm, PfmErrors) {
  EXPECT_NE(pfm_error("PX\n1 1\n-1\n").find("PF or Pf"), std::string::npos);
  EXPECT_NE(pfm_error("PF\n1 1\n0\n" + std::string(12, '\0')).find("scale"), std::string::npos);
  EXPECT_NE(pfm_error("PF\n1 1\nnan\n" + std::string(12, '\0')).find("'nan'"), std::string::npos);
  EXPECT_NE(pfm_error("PF\n100000 100000\n-1\n").find("100000 x 100000"), std::string::npos);
}

}  // namespace
}  // namespace pnm_test
