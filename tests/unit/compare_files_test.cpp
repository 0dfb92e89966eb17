// What `compare` says of two files: "identical" only of equal samples, and otherwise what differs.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "image/metrics.h"
#include "image/pnm.h"
#include "study/metric.h"
#include "support/png_parts.h"
#include "support/run_cli.h"

namespace ps::compare_files_test {
namespace {

using nlohmann::json;
using test::big_endian;
using test::png_chunk;
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

/// A PNG of one pixel; the data follow in one stored block.
std::string png_pixel(char depth, char colour_type, const std::string& samples) {
  const std::string row = std::string(1, '\0') + samples;
  const auto size = static_cast<char>(row.size());
  const std::string data = std::string("\x78\x01\x01") + size + std::string(1, '\0') + static_cast<char>(~size) +
                           std::string(1, '\xff') + row + std::string(4, '\0');
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR", big_endian(1) + big_endian(1) + std::string{depth, colour_type, 0, 0, 0}) +
         png_chunk("IDAT", data) + png_chunk("IEND", "");
}

std::string pfm_pixel(float value) { return pfm_bytes(Image<Vec3f>(1, 1, Vec3f(value))); }

struct Pair {
  const char* name;
  std::string a, b;
  const char* extension;
  const char* words;  ///< in the text
};

TEST(CompareFiles, IdenticalIsSaidOfEqualSamplesOnly) {
  const float nan = std::nanf(""), infinity = INFINITY;
  const Pair hidden[] = {
      {"beyond white", pfm_pixel(5), pfm_pixel(1), ".pfm", "values differ by at most 4 "},
      {"below black", pfm_pixel(-3), pfm_pixel(0), ".pfm", "values differ by at most 3 "},
      {"below a level", pfm_pixel(0.5f), pfm_pixel(0.501f), ".pfm", "values differ by at most 0.000999"},
      {"NaN", pfm_pixel(nan), pfm_pixel(0), ".pfm", "pixels not finite      1\n"},
      {"infinite", pfm_pixel(infinity), pfm_pixel(1), ".pfm", "pixels not finite      1\n"},
      {"a step of 65535", png_pixel(16, 0, "\x12\x34"), png_pixel(16, 0, "\x12\x35"), ".png", "at most 1.52"},
      {"alpha", png_pixel(8, 6, "abc\x33"), png_pixel(8, 6, "abc\x66"), ".png", "differs in 1 pixel, by at most 0.2\n"},
      {"alpha beside none", png_pixel(8, 6, "abc\x33"), png_pixel(8, 2, "abc"), ".png", "by at most 0.8\n"}};
  for (const Pair& pair : hidden) {
    SCOPED_TRACE(pair.name);
    const ScratchFolder folder;
    const std::string a = folder.write(std::string("a") + pair.extension, pair.a),
                      b = folder.write(std::string("b") + pair.extension, pair.b);
    const auto text = run_cli_well({"compare", a, b});
    EXPECT_TRUE(text.out.starts_with("identical in ")) << text.out;
    EXPECT_NE(text.out.find(pair.words), std::string::npos) << text.out;
    for (const char* values : {"", "--linear"}) {
      std::vector<std::string> arguments{"compare", a, b, "--json", "--identical"};
      if (*values != '\0') arguments.emplace_back(values);
      const auto result = run_cli(arguments);
      EXPECT_EQ(result.status, 1);
      const json found = json::parse(result.out);
      EXPECT_EQ(found["identical"], false);
      EXPECT_EQ(found["identical-levels"], true);
    }
    EXPECT_NE(run_cli({"compare", a, b, "--linear"}).out, "identical\n");
    const auto same = run_cli_well({"compare", a, a, "--identical"});
    EXPECT_EQ(same.out, "identical\n") << "a NaN is equal to itself";
  }
}

TEST(CompareFiles, LevelsThatDifferAreMeasuredAndAlphaIsNamedBesides) {
  const ScratchFolder folder;
  const std::string a = folder.write("a.png", png_pixel(8, 6, "abc\x33")),
                    b = folder.write("b.png", png_pixel(8, 6, "abd\x34"));
  const auto text = run_cli({"compare", a, b, "--identical"});
  EXPECT_EQ(text.status, 1);
  EXPECT_EQ(run_cli({"compare", a, b}).status, 0) << "it could compare";
  EXPECT_NE(text.out.find("largest difference     1 levels of 255"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("alpha                  differs in 1 pixel"), std::string::npos) << text.out;
  const json found = json::parse(run_cli({"compare", a, b, "--json"}).out);
  EXPECT_EQ(found["identical-levels"], false);
  EXPECT_EQ(found["alpha"]["differing"], 1);
}

// The same levels in files of 8 and 16 bits, and of another format: the samples are equal.
TEST(CompareFiles, FormatsDoNotMatter) {
  const ScratchFolder folder;
  const std::string a = folder.write("a.png", png_pixel(8, 0, "\x47")),
                    b = folder.write("b.png", png_pixel(16, 0, "\x47\x47")),
                    c = folder.write("c.ppm", "P3 1 1 255 71 71 71\n"),
                    opaque = folder.write("d.png", png_pixel(8, 4, "\x47\xff"));
  for (const std::string& other : {b, c, opaque}) EXPECT_EQ(run_cli({"compare", a, other}).out, "identical\n") << other;
}

TEST(CompareFiles, NotesAreOnStandardErrorOrInTheJson) {
  const ScratchFolder folder;
  const std::string a = folder.write("a.jpg", png_pixel(8, 0, "\x47"));
  const auto text = run_cli({"compare", a, a});
  EXPECT_EQ(text.out, "identical\n");
  EXPECT_NE(text.err.find("a.jpg: is read as PNG, as its content says.\n"), std::string::npos) << text.err;
  const auto result = run_cli({"compare", a, a, "--json"});
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(json::parse(result.out)["notes"].size(), 2U);
}

// A point of a chart is compared in levels, and is identical only if its values are.
TEST(CompareFiles, ChartsKnowSamplesFromLevels) {
  const Image<Rgb8> levels(2, 2, {9, 9, 9});
  const MeasuredPicture a{levels, Image<Vec3f>(2, 2, Vec3f(9 / 255.0f))}, b{levels, Image<Vec3f>(2, 2, Vec3f(0.0354f))};
  EXPECT_TRUE(compare_pictures(a, a, {}).identical);
  const Comparison apart = compare_pictures(a, b, {});
  EXPECT_FALSE(apart.identical);
  EXPECT_TRUE(apart.identical_levels);
}

}  // namespace
}  // namespace ps::compare_files_test
