// Damaged picture files of every kind: reading one gives a picture or an InputError, never anything else. Run under the
// sanitizers, this also shows that no byte outside the file is read.
#include <gtest/gtest.h>

#include <random>

#include "base/atomic_file.h"
#include "fuzz/mend_png.h"
#include "image/codec.h"
#include "image/display.h"
#include "image/file.h"
#include "image/pnm.h"
#include "support/golden.h"

namespace damaged_picture_test {
namespace {

using ps::Image;
using ps::Rgb8;

Image<Rgb8> gradient(int width, int height) {
  Image<Rgb8> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(x * 9), static_cast<std::uint8_t>(y * 13),
                        static_cast<std::uint8_t>(x * y)};
  return image;
}

/// Run-length encoded TGA of 4 x 2: a run of 5 and 3 single pixels.
std::string tga() {
  return std::string("\0\0\x0a\0\0\0\0\0\0\0\0\0\4\0\2\0\x18\0", 18) + "\x84" + "abc" + "\x02" + "defghijkl";
}

struct Kind {
  const char* name;
  std::string bytes;
};

TEST(DamagedPictures, GiveAPictureOrAnInputError) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto folder = ps::fresh_output_folder("damaged-pictures");
  const Kind kinds[] = {{"a.png", ps::stb_encode_png(gradient(12, 9))},
                        {"a.jpg", ps::read_whole_file("tests/unit/data/flat.jpg")},
                        {"a.tga", tga()},
                        {"a.ppm", ps::ppm_bytes(gradient(5, 3), {.texts = {}, .pnm = ps::PnmForm::ascii})},
                        {"b.ppm", ps::ppm_bytes(gradient(5, 3), {})},
                        {"a.pfm", ps::pfm_bytes(ps::to_unit(gradient(5, 3)))}};
  for (const Kind& kind : kinds) {
    int pictures = 0;
    int errors = 0;
    for (int round = 0; round < 150; ++round) {
      std::string bytes = kind.bytes;
      const auto at = [&] { return std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random); };
      for (int change = static_cast<int>(random() % 4); change >= 0; --change) {
        switch (random() % 4) {
        case 0:
          bytes[at()] = static_cast<char>(random());
          break;
        case 1:
          bytes[at()] ^= static_cast<char>(1u << random() % 8);
          break;
        case 2:
          bytes.insert(at(), 1, static_cast<char>(random()));
          break;
        case 3:
          if (bytes.size() > 1) bytes.erase(at(), 1);
          break;
        }
      }
      if (kind.name == std::string("a.png")) ps::fuzz::mend_png(bytes);
      ps::write_file_atomically(folder / kind.name, bytes);
      try {
        const auto image = ps::load_image(folder / kind.name);
        EXPECT_GT(image.width() * image.height(), 0);
        ++pictures;
      } catch (const ps::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(kind.name), std::string::npos) << error.what();
        ++errors;
      }
    }
    EXPECT_GT(errors, 0) << kind.name;
    EXPECT_GT(pictures, 0) << kind.name << ": some damage is harmless";
  }
}

/// Fills freed memory of many sizes with `value`, for what is read there without having been written.
void leave_in_memory(int value) {
  std::vector<std::vector<unsigned char>> blocks;
  for (std::size_t size = 64; size <= 65536; size += 64) blocks.emplace_back(size, static_cast<unsigned char>(value));
}

// The decoder reads Huffman tables that a file names and does not define: what it finds there may not be left over.
TEST(DamagedPictures, TablesThatAreNotDefinedAreAlwaysTheSame) {
  std::string bytes = ps::read_whole_file("tests/corpus/jpeg/restarts.jpg");
  for (std::size_t at = bytes.find("\xff\xc4"); at != std::string::npos; at = bytes.find("\xff\xc4")) {
    const auto length = static_cast<std::size_t>(static_cast<unsigned char>(bytes[at + 2]) << 8 |
                                                 static_cast<unsigned char>(bytes[at + 3]));
    bytes.erase(at, 2 + length);
  }
  const auto outcome = [&](int left) -> std::string {
    leave_in_memory(left);
    try {
      const auto image = ps::decode_picture(bytes, "a.jpg").colour;
      return std::to_string(image.width());
    } catch (const ps::InputError& error) {
      return error.what();
    }
  };
  const std::string first = outcome(0);
  for (const int left : {0xff, 0x11, 0x80, 0x01}) EXPECT_EQ(outcome(left), first) << left;
}

}  // namespace
}  // namespace damaged_picture_test
