// TGA files written here by the specification (Truevision TGA 2.0), from all four corners, plain and run-length
// encoded.
#include <gtest/gtest.h>

#include <array>
#include <tuple>

#include "image/file.h"
#include "image/tga.h"

namespace ps::tga_test {
namespace {

constexpr int width = 5, height = 4;

enum class Samples { grey8, grey_alpha, bits15, bits16, bits24, bits32, palette8, palette16 };

/// The level of a channel (red, green, blue, alpha) of the picture that all files hold; in 5 bits for 15 and 16.
int level(int x, int y, int channel) {
  // Two pixels beside each other are equal in the lower rows, so that there are runs, some of them across rows.
  const int place = y < 2 ? y * width + x : y * width + x / 2;
  return (place * 37 + channel * 71) % 256;
}

std::string word(int value) { return {static_cast<char>(value & 255), static_cast<char>(value >> 8)}; }

std::string colour_bytes(int x, int y, int bits) {
  std::string bytes;
  if (bits <= 16) {
    const int fifths = (level(x, y, 0) / 8) << 10 | (level(x, y, 1) / 8) << 5 | level(x, y, 2) / 8;
    return word(fifths | (bits == 16 && level(x, y, 3) >= 128 ? 1 << 15 : 0));
  }
  for (const int channel : {2, 1, 0, 3})
    if (channel < 3 || bits == 32) bytes += static_cast<char>(level(x, y, channel));
  return bytes;
}

constexpr int first_entry = 300;  // of the palettes; a wide index is needed for it

struct Written {
  Samples samples = Samples::bits24;
  bool from_right = false, from_top = false, runs = false;
  bool unused_palette = false;  ///< a palette that no pixel reads
};

std::string pixel_bytes(const Written& written, int x, int y) {
  switch (written.samples) {
  case Samples::grey8:
    return {static_cast<char>(level(x, y, 0))};
  case Samples::grey_alpha:
    return {static_cast<char>(level(x, y, 0)), static_cast<char>(level(x, y, 3))};
  case Samples::bits15:
    return colour_bytes(x, y, 15);
  case Samples::bits16:
    return colour_bytes(x, y, 16);
  case Samples::bits24:
    return colour_bytes(x, y, 24);
  case Samples::bits32:
    return colour_bytes(x, y, 32);
  case Samples::palette8:
    return {static_cast<char>(100 + y * width + x)};
  case Samples::palette16:
    return word(first_entry + y * width + x);
  }
  return {};
}

/// The picture's pixels as the palette, in reading order.
std::string palette_bytes(int bits) {
  std::string bytes;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) bytes += colour_bytes(x, y, bits);
  return bytes;
}

std::string file_of(const Written& written) {
  const bool is_palette = written.samples == Samples::palette8 || written.samples == Samples::palette16;
  const bool is_grey = written.samples == Samples::grey8 || written.samples == Samples::grey_alpha;
  const int bits = static_cast<int>(8 * pixel_bytes(written, 0, 0).size()) - (written.samples == Samples::bits15);
  const bool has_palette = is_palette || written.unused_palette;
  const bool has_alpha = bits == 32 || written.samples == Samples::bits16 || written.samples == Samples::grey_alpha;
  std::string bytes{3, static_cast<char>(has_palette),
                    static_cast<char>((is_palette ? 1
                                       : is_grey  ? 3
                                                  : 2) +
                                      (written.runs ? 8 : 0))};
  const int first = written.samples == Samples::palette16 ? first_entry : is_palette ? 100 : 0;
  const int entry_bits = written.samples == Samples::palette16 ? 15 : 24;
  bytes += has_palette ? word(first) + word(width * height) + static_cast<char>(entry_bits) : std::string(5, '\0');
  bytes += word(7) + word(9) + word(width) + word(height) + static_cast<char>(bits);
  bytes += static_cast<char>((has_alpha ? bits == 16 && !is_grey ? 1 : 8 : 0) | (written.from_right ? 16 : 0) |
                             (written.from_top ? 32 : 0));
  bytes += "id!";
  if (has_palette) bytes += palette_bytes(entry_bits);
  std::vector<std::string> pixels;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      pixels.push_back(pixel_bytes(written, written.from_right ? width - 1 - column : column,
                                   written.from_top ? row : height - 1 - row));
  for (std::size_t i = 0; i < pixels.size();) {
    std::size_t end = i + 1;
    while (written.runs && end < pixels.size() && pixels[end] == pixels[i]) ++end;
    if (written.runs) bytes += static_cast<char>(end - i > 1 ? 128 + (end - i - 1) : 0);
    bytes += pixels[i];
    i = end;
  }
  return bytes;
}

void expect_read(const Written& written) {
  const StoredPicture picture = decode_picture(file_of(written), "a.tga");
  ASSERT_EQ(picture.colour.width(), width);
  ASSERT_EQ(picture.colour.height(), height);
  const bool is_grey = written.samples == Samples::grey8 || written.samples == Samples::grey_alpha;
  const bool fifths =
      written.samples == Samples::bits15 || written.samples == Samples::bits16 || written.samples == Samples::palette16;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const int stored = level(x, y, is_grey ? 0 : channel);
        const int kept = fifths ? stored >> 3 : stored;  // the upper five bits
        const float value = static_cast<float>(kept) / (fifths ? 31 : 255);
        EXPECT_EQ(picture.colour.at(x, y)[channel], value) << x << ", " << y << ": " << channel;
      }
  const bool has_alpha = written.samples == Samples::bits16 || written.samples == Samples::bits32 ||
                         written.samples == Samples::grey_alpha;
  ASSERT_EQ(picture.alpha.empty(), !has_alpha);
  for (int y = 0; y < height && has_alpha; ++y)
    for (int x = 0; x < width; ++x) {
      const int stored = level(x, y, 3);
      const float value = fifths ? static_cast<float>(stored >= 128) : static_cast<float>(stored) / 255;
      EXPECT_EQ(picture.alpha.at(x, y), value) << x << ", " << y;
    }
  EXPECT_TRUE(picture.notes.empty());
}

TEST(Tga, ReadsEveryKindFromEveryCorner) {
  for (int kind = 0; kind < 8; ++kind)
    for (int corner = 0; corner < 4; ++corner)
      for (const bool runs : {false, true})
        for (const bool unused_palette : {false, true}) {
          SCOPED_TRACE(testing::Message() << "kind " << kind << ", corner " << corner << ", runs " << runs
                                          << ", unused palette " << unused_palette);
          expect_read({static_cast<Samples>(kind), corner % 2 == 1, corner >= 2, runs, unused_palette});
        }
}

TEST(Tga, RefusesIndicesOutsideThePalette) {
  std::string bytes = file_of({Samples::palette8});
  for (const int index : {99, 100 + width * height}) {
    bytes.back() = static_cast<char>(index);
    EXPECT_THROW(read_tga(bytes, "a.tga", 1000), InputError) << index;
  }
  bytes.back() = 100;
  EXPECT_NO_THROW(read_tga(bytes, "a.tga", 1000));
}

// Programs that know of no opacity leave the fourth byte empty; one that says how many bits it has means them.
TEST(Tga, AnEmptyFourthByteIsNoOpacity) {
  std::string bytes = file_of({Samples::bits32});
  const std::size_t pixels_at = bytes.size() - 4 * width * height;
  for (std::size_t i = pixels_at; i < bytes.size(); i += 4) bytes[i + 3] = '\0';
  EXPECT_EQ(read_tga(bytes, "a.tga", 1000).alpha, Image<float>(width, height, 0.0f));
  bytes[17] = '\0';
  EXPECT_TRUE(read_tga(bytes, "a.tga", 1000).alpha.empty());
  bytes.back() = '\x33';
  EXPECT_EQ(read_tga(bytes, "a.tga", 1000).alpha.at(width - 1, 0), 0.2f);
}

// Rows 0, 2, 4 ... and then 1, 3 ...; or every fourth (TGA 1.0).
TEST(Tga, ReadsInterleavedRows) {
  for (const auto& [code, order] :
       {std::tuple(1, std::array{0, 2, 4, 1, 3}), std::tuple(2, std::array{0, 4, 1, 2, 3})}) {
    std::string bytes("\0\0\3\0\0\0\0\0\0\0\0\0\1\0\5\0\x08", 17);
    bytes += static_cast<char>(code << 6 | 32);
    for (const int row : order) bytes += static_cast<char>(row);
    const Image<Vec3f> read = decode_picture(bytes, "a.tga").colour;
    for (int y = 0; y < 5; ++y) EXPECT_EQ(read.at(0, y).r, static_cast<float>(y) / 255) << code;
  }
}

}  // namespace
}  // namespace ps::tga_test
