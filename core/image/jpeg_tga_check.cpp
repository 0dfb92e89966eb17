#include "image/jpeg_tga_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/image.h"

namespace ps {

namespace {

enum Marker : unsigned {
  first_frame = 0xc0,
  last_frame = 0xc2,  ///< those that the decoder knows
  huffman_tables = 0xc4,
  first_restart = 0xd0,
  last_restart = 0xd7,
  start_of_image = 0xd8,
  end_of_image = 0xd9,
  start_of_scan = 0xda
};

class JpegSegments {
 public:
  JpegSegments(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  std::string_view checked() {
    if (bytes_.size() < 2 || byte(0) != 0xff || byte(1) != start_of_image)
      fail("found no JPEG signature, expected a JPEG file");
    at_ = 2;
    for (;;) {
      const unsigned marker = next_marker();
      if (marker == end_of_image) return finished();
      const std::string_view data = segment(marker);
      if (marker == huffman_tables) check_tables(data);
      if (marker >= first_frame && marker <= last_frame) note_size(data);
      if (marker == start_of_scan) skip_scan();
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(fmt::format("{}: {}", file_, what)); }
  [[noreturn]] void fail_cut() const { fail(fmt::format("JPEG is cut off at byte {}: no end marker", bytes_.size())); }
  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }

  unsigned next_marker() {
    if (at_ >= bytes_.size()) fail_cut();
    if (byte(at_) != 0xff) fail(fmt::format("found no JPEG marker at byte {}", at_));
    while (at_ < bytes_.size() && byte(at_) == 0xff) ++at_;
    if (at_ >= bytes_.size()) fail_cut();
    return byte(at_++);
  }

  /// The data of the segment whose length comes next.
  std::string_view segment(unsigned marker) {
    constexpr std::size_t length_bytes = 2;
    if (bytes_.size() - at_ < length_bytes) fail_cut();
    const std::size_t length = byte(at_) << 8 | byte(at_ + 1);
    if (length < length_bytes) fail(fmt::format("JPEG segment {:02x} has a length of {}", marker, length));
    if (length > bytes_.size() - at_) fail_cut();
    const std::string_view data = bytes_.substr(at_ + length_bytes, length - length_bytes);
    at_ += length;
    return data;
  }

  void check_tables(std::string_view data) const {
    constexpr std::size_t lengths = 16;
    constexpr std::size_t most_codes = 256;
    while (!data.empty()) {
      if (data.size() < 1 + lengths) fail("JPEG Huffman table is cut off");
      std::size_t codes = 0;
      for (std::size_t i = 1; i <= lengths; ++i) codes += static_cast<unsigned char>(data[i]);
      if (codes > most_codes) fail(fmt::format("JPEG Huffman table has {} codes, expected at most 256", codes));
      if (data.size() < 1 + lengths + codes) fail("JPEG Huffman table is cut off");
      data.remove_prefix(1 + lengths + codes);
    }
  }

  void note_size(std::string_view data) {
    constexpr std::size_t size_end = 5;
    if (data.size() < size_end) fail("JPEG frame header is cut off");
    const auto word = [&](std::size_t at) {
      return std::int64_t{static_cast<unsigned char>(data[at])} << 8 | static_cast<unsigned char>(data[at + 1]);
    };
    require_image_size(word(3), word(1), file_);
    pixels_ = std::max(pixels_, static_cast<std::size_t>(word(3) * word(1)));
  }

  /// Each block of 8 x 8 pixels takes at least a bit, so a short file cannot hold a huge picture.
  std::string_view finished() const {
    constexpr std::size_t most_pixels_per_byte = 8 * 64;
    if (pixels_ / most_pixels_per_byte > at_)
      fail(fmt::format("JPEG has {} bytes, too few for its {} pixels", at_, pixels_));
    return bytes_.substr(0, at_);
  }

  /// To the marker that ends the compressed data; 0xff 0x00 is a data byte. Fill bytes are let through only before the
  /// end of the picture, since decoders read them in different ways.
  void skip_scan() {
    for (; at_ + 1 < bytes_.size(); ++at_) {
      if (byte(at_) != 0xff) continue;
      const unsigned next = byte(at_ + 1);
      if (next == 0 || (next >= first_restart && next <= last_restart)) continue;
      std::size_t end = at_ + 1;
      while (end < bytes_.size() && byte(end) == 0xff) ++end;
      if (end > at_ + 1 && (end == bytes_.size() || byte(end) != end_of_image))
        fail(fmt::format("found fill bytes inside JPEG data at byte {}", at_));
      return;
    }
    fail_cut();
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t pixels_ = 0;
};

}  // namespace

std::string_view checked_jpeg(std::string_view bytes, const std::string& file) {
  return JpegSegments(bytes, file).checked();
}

void check_tga(std::string_view bytes, const std::string& file) {
  constexpr std::size_t header_size = 18;
  if (bytes.size() < header_size)
    throw InputError(fmt::format("{}: TGA is cut off: found {} bytes, expected a header of 18", file, bytes.size()));
  const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])); };
  const auto word = [&](std::size_t at) { return byte(at) | byte(at + 1) << 8; };
  require_image_size(static_cast<std::int64_t>(word(12)), static_cast<std::int64_t>(word(14)), file);
  constexpr std::size_t rle = 8;
  const bool compressed = (byte(2) & rle) != 0;
  const std::size_t palette = byte(1) == 0 ? 0 : word(5) * ((byte(7) + 7) / 8);
  constexpr std::size_t longest_run = 128;
  const std::size_t count = word(12) * word(14);
  const std::size_t pixel_bytes = (byte(16) + 7) / 8;
  const std::size_t pixels =
      compressed ? (count + longest_run - 1) / longest_run * (1 + pixel_bytes) : count * pixel_bytes;
  const std::size_t expected = header_size + byte(0) + palette + pixels;
  if (bytes.size() < expected)
    throw InputError(
        fmt::format("{}: TGA is cut off: found {} bytes, expected at least {}", file, bytes.size(), expected));
}

}  // namespace ps
