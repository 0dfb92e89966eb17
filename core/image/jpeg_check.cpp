#include "image/jpeg_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/exif.h"
#include "image/image.h"

namespace ps {

namespace {

enum Marker : unsigned {
  first_frame = 0xc0,
  progressive_frame = 0xc2,
  last_frame = 0xc2,  ///< those that the decoder knows
  huffman_tables = 0xc4,
  first_restart = 0xd0,
  last_restart = 0xd7,
  start_of_image = 0xd8,
  end_of_image = 0xd9,
  start_of_scan = 0xda,
  exif_segment = 0xe1
};

class JpegSegments {
 public:
  JpegSegments(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  JpegInfo checked() {
    if (bytes_.size() < 2 || byte(0) != 0xff || byte(1) != start_of_image)
      fail("found no JPEG signature, expected a JPEG file");
    at_ = 2;
    while (info_.ended) {
      const unsigned marker = next_marker();
      if (marker == end_of_image) break;
      const std::string_view data = segment(marker);
      if (marker == huffman_tables) check_tables(data);
      if (marker >= first_frame && marker <= last_frame) note_frame(marker, data);
      if (marker == exif_segment && data.starts_with(exif_head)) info_.orientation = exif_orientation(data.substr(6));
      if (marker == start_of_scan) skip_scan(data);
    }
    return finished();
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

  void note_frame(unsigned marker, std::string_view data) {
    constexpr std::size_t frame_head = 6;
    if (data.size() < frame_head) fail("JPEG frame header is cut off");
    const auto word = [&](std::size_t at) {
      return std::int64_t{static_cast<unsigned char>(data[at])} << 8 | static_cast<unsigned char>(data[at + 1]);
    };
    require_image_size(word(3), word(1), file_);
    pixels_ = std::max(pixels_, static_cast<std::size_t>(word(3) * word(1)));
    components_left_ = static_cast<unsigned char>(data[5]);
    one_scan_each_ = marker != progressive_frame;
  }

  /// Each block of 8 x 8 pixels takes at least a bit, so a short file cannot hold a huge picture.
  JpegInfo finished() {
    constexpr std::size_t most_pixels_per_byte = 8 * 64;
    if (pixels_ / most_pixels_per_byte > at_)
      fail(fmt::format("JPEG has {} bytes, too few for its {} pixels", at_, pixels_));
    info_.bytes = bytes_.substr(0, at_);
    return info_;
  }

  /// To the marker that ends the compressed data; 0xff 0x00 is a data byte. Fill bytes are let through only before the
  /// end of the picture, since decoders read them in different ways.
  void skip_scan(std::string_view head) {
    components_left_ -= head.empty() ? 0 : static_cast<unsigned char>(head[0]);
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
    if (components_left_ > 0 || !one_scan_each_) fail_cut();  // further scans may be missing
    if (at_ < bytes_.size() && byte(at_) != 0xff) ++at_;
    info_.ended = false;
  }

  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::size_t pixels_ = 0;
  int components_left_ = 0;     ///< those of the frame without a scan so far
  bool one_scan_each_ = false;  ///< false: a progressive picture becomes finer with each scan
  JpegInfo info_;
};

}  // namespace

JpegInfo check_jpeg(std::string_view bytes, const std::string& file) { return JpegSegments(bytes, file).checked(); }

}  // namespace ps
