// A damaged picture file reads the same way each time. That all of them are read or refused, the tests of the corpus
// try.
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/file.h"

namespace damaged_picture_test {
namespace {

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
