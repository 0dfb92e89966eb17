#include "image/file.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <random>

#include "base/atomic_file.h"
#include "image/display.h"
#include "support/golden.h"
#include "support/refusal.h"

namespace image_file_test {
namespace {

using ps::Image;
using ps::Rgb8;
using ps::Vec3f;

Image<Rgb8> noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image<Rgb8> image(width, height);
  for (Rgb8& p : image.pixels()) {
    const auto bits = random();
    p = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8), static_cast<std::uint8_t>(bits >> 16)};
  }
  return image;
}

TEST(ImageFile, RoundTripsOfLevelsAreExact) {
  const auto folder = ps::fresh_output_folder("image-file-levels");
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {1, 40}, {256, 5}}) {
    const auto image = noise(width, height, seed);
    for (const char* name : {"a.png", "a.PNG", "a.ppm"}) {
      ps::save_image(folder / name, image);
      EXPECT_EQ(ps::load_levels(folder / name), image) << name;
      EXPECT_EQ(ps::load_image(folder / name), ps::to_unit(image)) << name;
    }
    ps::save_image(folder / "b.ppm", image, {.texts = {{"note", "two\nlines"}}, .pnm = ps::PnmForm::ascii});
    EXPECT_EQ(ps::load_levels(folder / "b.ppm"), image);
  }
}

TEST(ImageFile, RoundTripsOfFloatsAreExactToTheBit) {
  const auto folder = ps::fresh_output_folder("image-file-floats");
  Image<Vec3f> image(5, 4);
  std::uint32_t bits = 12345;
  for (Vec3f& p : image.pixels())
    for (int c = 0; c < 3; ++c) p[c] = std::bit_cast<float>(bits = bits * 1664525 + 1013904223);
  image.at(0, 0) = {std::numeric_limits<float>::infinity(), -0.0f, std::numeric_limits<float>::quiet_NaN()};
  image.at(4, 3) = {std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(), -1};
  ps::save_pfm(folder / "a.pfm", image);
  const auto loaded = ps::load_image(folder / "a.pfm");
  ASSERT_EQ(loaded.width(), 5);
  ASSERT_EQ(loaded.height(), 4);
  for (std::size_t i = 0; i < image.pixels().size(); ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(std::bit_cast<std::uint32_t>(loaded.pixels()[i][c]),
                std::bit_cast<std::uint32_t>(image.pixels()[i][c]));
}

TEST(ImageFile, PfmRowsAreStoredFromTheBottomInTheNamedByteOrder) {
  const auto folder = ps::fresh_output_folder("image-file-pfm");
  // 1.0f is 3f800000, 2.0f is 40000000; grey, big-endian.
  ps::write_file_atomically(folder / "big.pfm", std::string_view("Pf\n1 2\n1.0\n\x3f\x80\0\0\x40\0\0\0", 19));
  const auto big = ps::load_image(folder / "big.pfm");
  EXPECT_EQ(big.at(0, 0), Vec3f(2));
  EXPECT_EQ(big.at(0, 1), Vec3f(1));
  ps::write_file_atomically(folder / "little.pfm",
                            std::string_view("PF 1 1 -1\n\0\0\x80\x3f\0\0\0\x40\0\0\x80\xbf", 22));
  EXPECT_EQ(ps::load_image(folder / "little.pfm").at(0, 0), Vec3f(1, 2, -1));
}

TEST(ImageFile, ReadsTheReferencePictures) {
  // The red sphere of the book's first picture is flat (255, 0, 0) at book pixel (0, -200); the corner is white.
  const auto image = ps::load_levels(ps::reference_path("raytracer-01.png"));
  ASSERT_EQ(image.width(), 600);
  ASSERT_EQ(image.height(), 600);
  EXPECT_EQ(image.at(300, 499), (Rgb8{255, 0, 0}));
  EXPECT_EQ(image.at(0, 0), (Rgb8{255, 255, 255}));
  EXPECT_EQ(image.at(0, 599), (Rgb8{255, 255, 0}));
}

TEST(ImageFile, ReadsTgaAndJpeg) {
  const auto folder = ps::fresh_output_folder("image-file-tga");
  // 2 x 1, 24 bits, stored as BGR from the bottom left.
  const std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0\x01\x02\x03\xff\x80\0", 24);
  ps::write_file_atomically(folder / "a.tga", tga);
  const auto image = ps::load_levels(folder / "a.tga");
  ASSERT_EQ(image.width(), 2);
  EXPECT_EQ(image.at(0, 0), (Rgb8{3, 2, 1}));
  EXPECT_EQ(image.at(1, 0), (Rgb8{0, 128, 255}));
  for (std::size_t length = 0; length < tga.size(); ++length) {
    ps::write_file_atomically(folder / "cut.tga", tga.substr(0, length));
    EXPECT_THROW(ps::load_image(folder / "cut.tga"), ps::InputError) << length << " bytes";
  }

  // 16 x 16 of one colour, (200, 100, 50): JPEG keeps flat colours to a few levels.
  const std::string jpeg = ps::read_whole_file("tests/unit/data/flat.jpg");
  const auto flat = ps::load_levels("tests/unit/data/flat.jpg");
  ASSERT_EQ(flat.width(), 16);
  ASSERT_EQ(flat.height(), 16);
  for (const Rgb8 p : flat.pixels()) {
    EXPECT_NEAR(p.r, 200, 3);
    EXPECT_NEAR(p.g, 100, 3);
    EXPECT_NEAR(p.b, 50, 3);
  }
  for (std::size_t length = 0; length + 3 < jpeg.size(); ++length) {  // without the end marker it is whole
    ps::write_file_atomically(folder / "cut.jpg", jpeg.substr(0, length));
    EXPECT_THROW(ps::load_image(folder / "cut.jpg"), ps::InputError) << length << " bytes";
  }
}

// What the decoder itself would take: a table that overflows its memory, and pixels out of nothing.
TEST(ImageFile, RefusesWhatTheDecoderWouldNot) {
  const auto folder = ps::fresh_output_folder("image-file-decoder");
  const std::string good = ps::read_whole_file("tests/unit/data/flat.jpg");
  const auto error = [&](const char* name, const std::string& bytes) {
    ps::write_file_atomically(folder / name, bytes);
    return ps::test::refusal_of([&] { ps::load_image(folder / name); });
  };
  EXPECT_EQ(error("good.jpg", good), "");
  EXPECT_EQ(error("good.jpg", good + "after the end"), "");

  std::string table("\xff\xc4\x01\x14\0", 5);  // 3 + 16 + 257 bytes of one table, all codes of one length
  table += std::string(14, '\0') + "\xff\x02" + std::string(257, 'x');
  EXPECT_NE(error("table.jpg", std::string(good).insert(2, table)).find("257 codes"), std::string::npos)
      << error("table.jpg", std::string(good).insert(2, table));

  std::string huge = good;
  const auto frame = huge.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  huge.replace(frame + 5, 4, std::string("\x3f\xff\x3f\xff", 4));
  EXPECT_NE(error("huge.jpg", huge).find("too few for its 268402689 pixels"), std::string::npos);

  const std::string empty_runs("\0\0\x0a\0\0\0\0\0\0\0\0\0\xff\x3f\xff\x3f\x18\0", 18);
  EXPECT_NE(error("huge.tga", empty_runs).find("of 16383 x 16383 pixels, which takes"), std::string::npos)
      << error("huge.tga", empty_runs);
}

TEST(ImageFile, NamesWhatIsWrong) {
  const auto folder = ps::fresh_output_folder("image-file-bad");
  const Image<Rgb8> image(2, 2);
  const auto save = [&](const char* name) {
    return ps::test::refusal_of([&] { ps::save_image(folder / name, image); });
  };
  const auto load = [&](const char* name) { return ps::test::refusal_of([&] { ps::load_image(folder / name); }); };
  EXPECT_NE(save("a.gif").find("\".gif\""), std::string::npos);
  EXPECT_NE(save("a").find("expected png or ppm"), std::string::npos);
  EXPECT_NE(save("none/a.png").find("does not exist"), std::string::npos);
  EXPECT_NE(ps::test::refusal_of([&] { ps::save_pfm(folder / "a.png", Image<Vec3f>(1, 1)); }).find("expected pfm"),
            std::string::npos);
  EXPECT_NE(load("none.png").find("no such file"), std::string::npos);
  ps::write_file_atomically(folder / "a.bmp", "BM and the rest");
  EXPECT_NE(load("a.bmp").find("\".bmp\""), std::string::npos);
  for (const char* name : {"e.png", "e.jpg", "e.tga", "e.ppm", "e.pfm"}) {
    ps::write_file_atomically(folder / name, "");
    EXPECT_NE(load(name).find("empty"), std::string::npos) << name;
    ps::write_file_atomically(folder / name, "not a picture at all, but long enough for any header");
    EXPECT_NE(load(name), "") << name;
  }
  std::filesystem::create_directory(folder / "folder.png");
  EXPECT_NE(load("folder.png").find("is a folder"), std::string::npos);
  EXPECT_NE(save("folder.png").find("is a folder"), std::string::npos);
}

TEST(AtomicFile, KeepsTheOldFileWhenItCannotWrite) {
  const auto folder = ps::fresh_output_folder("atomic-file");
  ps::write_file_atomically(folder / "a", "old");
  ps::write_file_atomically(folder / "a", std::string(100000, 'x'));
  EXPECT_EQ(ps::read_whole_file(folder / "a"), std::string(100000, 'x'));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "no temporary file is left";
  EXPECT_THROW(ps::write_file_atomically(folder / "a" / "b", "new"), ps::InputError);
  EXPECT_THROW(ps::write_file_atomically(folder / std::string(300, 'n'), "new"), ps::InputError);
  EXPECT_EQ(ps::read_whole_file(folder / "a").size(), 100000u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  EXPECT_THROW(ps::read_whole_file(folder / "a", 10), ps::InputError);

  std::filesystem::create_symlink("a", folder / "link");
  ps::write_file_atomically(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(ps::read_whole_file(folder / "a"), "new");
}

}  // namespace
}  // namespace image_file_test
