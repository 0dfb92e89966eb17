#include "image/png_chunks.h"

#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "image/codec.h"
#include "image/display.h"
#include "support/golden.h"
#include "support/png_parts.h"

namespace png_test {
namespace {

using ps::Image;
using ps::Rgb8;
using ps::test::big_endian;
using ps::test::png_chunk;

/// A small PNG with a text, from the program's own writer.
std::string small_png() {
  Image<Rgb8> image(5, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(50 * x), static_cast<std::uint8_t>(60 * y), 7};
  return ps::png_with_texts(ps::stb_encode_png(image), {{"permalink", "scene=cgfs/shadows&gamma=2.2"}});
}

std::string header(std::uint32_t width, std::uint32_t height, const std::string& rest) {
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", big_endian(width) + big_endian(height) + rest);
}

/// A zlib stream of one stored block; the decoder does not look at the checksum.
std::string stored(const std::string& data) {
  const auto n = static_cast<std::uint16_t>(data.size());
  const auto m = static_cast<std::uint16_t>(~n);
  return std::string("\x78\x01\x01") + static_cast<char>(n & 0xff) + static_cast<char>(n >> 8) +
         static_cast<char>(m & 0xff) + static_cast<char>(m >> 8) + data + std::string(4, '\0');
}

std::string error_of(const std::string& bytes) {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto path = ps::fresh_output_folder("png-error-" + test) / "bad.png";  // tests run side by side
  ps::write_file_atomically(path, bytes);
  try {
    ps::load_image(path);
  } catch (const ps::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("bad.png"), std::string::npos) << error.what();
    return error.what();
  }
  return {};
}

TEST(Png, CrcIsTheStandardOne) {
  EXPECT_EQ(ps::crc32("123456789"), 0xcbf43926u);  // the check value of CRC-32
  EXPECT_EQ(ps::crc32("IEND"), 0xae426082u);       // the end of every PNG file
}

TEST(Png, ACutBeforeItsLastChunkIsAnError) {
  const std::string png = small_png();
  EXPECT_EQ(error_of(png), "");
  constexpr std::size_t last_chunk = 12;
  for (std::size_t length = 0; length + last_chunk < png.size(); ++length)
    EXPECT_NE(error_of(png.substr(0, length)), "") << length << " of " << png.size() << " bytes";
}

TEST(Png, AnyFlippedBitIsAnError) {
  const std::string png = small_png();
  for (std::size_t byte = 0; byte < png.size(); ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = png;
      damaged[byte] = static_cast<char>(damaged[byte] ^ 1 << bit);
      EXPECT_THROW(ps::check_png(damaged, "x.png"), ps::InputError) << "bit " << bit << " of byte " << byte;
    }
  }
}

TEST(Png, ReportsWhatIsWrong) {
  const std::string rgb("\x08\x02\0\0\0", 5);
  const std::string data = png_chunk("IDAT", stored(std::string(4, '\0')));
  const std::string end = png_chunk("IEND", "");
  EXPECT_EQ(error_of(header(1, 1, rgb) + data + end), "");

  const auto expect = [&](const std::string& bytes, const std::string& part) {
    EXPECT_NE(error_of(bytes).find(part), std::string::npos) << "found: " << error_of(bytes) << "\nexpected: " << part;
  };
  std::string wrong_crc = small_png();
  wrong_crc[wrong_crc.size() - 1] ^= 1;
  expect(wrong_crc, "its CRC is ae426083");
  expect("GIF89a" + std::string(100, ' '), "no PNG signature");
  expect(header(0, 1, rgb) + data + end, "0 x 1");
  expect(header(1, 0x80000000u, rgb) + data + end, "1 x 2147483648");
  expect(header(0x80000000u, 0x80000000u, rgb) + data + end, "2147483648 x 2147483648");
  expect(header(1u << 15, (1u << 13) + 1, rgb) + data + end, "at most 268435456 pixels");
  const std::string rest = data + end;
  for (const int type : {1, 5, 7}) expect(header(1, 1, std::string{8, char(type), 0, 0, 0}) + rest, "colour type");
  for (const int depth : {0, 3, 99}) expect(header(1, 1, std::string{char(depth), 0, 0, 0, 0}) + rest, "bits");
  expect(header(1, 1, std::string{8, 2, 1, 0, 0}) + data + end, "compression method");
  expect(header(1, 1, std::string{8, 2, 0, 1, 0}) + data + end, "filter method");
  expect(header(1, 1, std::string{8, 2, 0, 0, 2}) + data + end, "interlace method");
  expect(header(1, 1, rgb) + end, "no IDAT");
  expect(header(1, 1, rgb) + data.substr(0, data.size() - 1), "cut off");
  expect(header(1, 1, rgb) + header(1, 1, rgb).substr(8) + data + end, "second IHDR");
  expect(data + end, "no PNG signature");
  expect(header(1, 1, rgb) + png_chunk("IDAT", "\x78\x01") + end, "cannot be decoded");
  expect(header(1, 1, rgb) + png_chunk("IDAT", stored(std::string(1, '\0'))) + end, "cannot be decoded");
  // A picture of 2^26 pixels, the most, whose data are missing is refused without that much memory being filled.
  expect(header(1u << 13, 1u << 13, rgb) + data + end, "cannot be decoded");
}

TEST(Png, PaletteIndicesBeyondThePaletteAreAnError) {
  const std::string indexed("\x08\x03\0\0\0", 5);
  const std::string end = png_chunk("IEND", "");
  const std::string palette = png_chunk("PLTE", std::string("\x01\x02\x03\x04\x05\x06"));
  const auto picture = [&](const std::string& indices) {
    return png_chunk("IDAT", stored(std::string(1, '\0') + indices)) + end;
  };
  EXPECT_EQ(error_of(header(2, 1, indexed) + palette + picture(std::string("\0\x01", 2))), "");
  EXPECT_NE(error_of(header(2, 1, indexed) + palette + picture("\x01\x02")).find("beyond the palette"),
            std::string::npos);
  EXPECT_NE(error_of(header(2, 1, indexed) + picture("\x01\x01")).find("without a palette"), std::string::npos);
  EXPECT_NE(error_of(header(2, 1, indexed) + png_chunk("PLTE", "1234") + picture("\x01\x01")).find("4 bytes"),
            std::string::npos);

  const auto path = ps::fresh_output_folder("png-palette") / "a.png";
  ps::write_file_atomically(path, header(2, 1, indexed) + palette + picture(std::string("\x01\0", 2)));
  const auto image = ps::load_levels(path);
  EXPECT_EQ(image.at(0, 0), (Rgb8{4, 5, 6}));
  EXPECT_EQ(image.at(1, 0), (Rgb8{1, 2, 3}));
}

TEST(Png, SixteenBitsKeepTheirPrecision) {
  const auto path = ps::fresh_output_folder("png-sixteen") / "a.png";
  const std::string grey16("\x10\0\0\0\0", 5);
  ps::write_file_atomically(path, header(1, 1, grey16) + png_chunk("IDAT", stored(std::string("\0\x12\x34", 3))) +
                                      png_chunk("IEND", ""));
  EXPECT_EQ(ps::load_image(path).at(0, 0), ps::Vec3f(0x1234 / 65535.0f));
}

// 100 MB of zeros pack into 100 kB; the header promises one pixel.
TEST(Png, ABombIsRefused) {
  std::string deflated("\x78\xda", 2);
  // Fixed-code blocks would do; runs of length 258 at distance 1 in one fixed-code block: literal 0, then matches.
  std::uint64_t bits = 0;
  int count = 0;
  const auto put = [&](std::uint32_t value, int length) {
    bits |= static_cast<std::uint64_t>(value) << count;
    for (count += length; count >= 8; count -= 8, bits >>= 8) deflated += static_cast<char>(bits & 0xff);
  };
  put(1, 1);           // last block
  put(1, 2);           // fixed codes
  put(0b00001100, 8);  // literal 0 is 00110000, most significant bit first
  for (int i = 0; i < 400000; ++i) {
    put(0b10100011, 8);  // length 258 is 11000101
    put(0, 5);           // distance 1
  }
  put(0, 7);  // end of block
  put(0, 7);
  const std::string bomb =
      header(1, 1, std::string("\x08\x02\0\0\0", 5)) + png_chunk("IDAT", deflated) + png_chunk("IEND", "");
  EXPECT_NE(error_of(bomb).find("cannot be decoded"), std::string::npos);
}

TEST(Png, KeepsTexts) {
  const auto path = ps::fresh_output_folder("png-texts") / "a.png";
  const std::vector<ps::ImageText> texts = {{"permalink", "a=b"},
                                            {"title", "crates of chapter 14, Gr\xc3\xb6\xc3\x9f"
                                                      "e 2"},
                                            {"empty", ""},
                                            {"lines", "one\ntwo"}};
  const Image<Rgb8> image(3, 2, {1, 2, 3});
  ps::save_image(path, image, {.texts = texts});
  EXPECT_EQ(ps::load_texts(path), texts);
  EXPECT_EQ(ps::load_levels(path), image);
  const std::string bytes = ps::read_whole_file(path);
  EXPECT_NE(bytes.find(std::string("tEXtpermalink\0a=b", 17)), std::string::npos);
  EXPECT_NE(bytes.find(std::string("iTXttitle\0\0\0\0\0crates", 20)), std::string::npos);
  EXPECT_THROW(ps::save_image(path, image, {.texts = {{"", "x"}}}), ps::InputError);
  EXPECT_THROW(ps::save_image(path, image, {.texts = {{std::string(80, 'k'), "x"}}}), ps::InputError);
  EXPECT_THROW(ps::save_image(path, image, {.texts = {{"key", std::string("a\0b", 3)}}}), ps::InputError);
  EXPECT_EQ(ps::load_texts(path), texts) << "the file is untouched";
}

}  // namespace
}  // namespace png_test
