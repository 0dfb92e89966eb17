#include "image/tga.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "image/read_limit.h"

namespace ps {
namespace {

constexpr std::size_t tga_header_size = 18;
constexpr std::size_t longest_run = 128;

/// The header: the first 18 bytes.
struct TgaHeader {
  enum class Kind { palette = 1, colour = 2, grey = 3 };

  std::size_t id_size = 0;
  bool has_palette = false;
  int type = 0;  ///< a Kind, 8 more where pixels are run-length encoded
  std::size_t first_entry = 0, entries = 0, entry_bits = 0;
  int width = 0, height = 0;
  std::size_t pixel_bits = 0;
  int descriptor = 0;  ///< bits 0-3 alpha bits, 4 from the right, 5 from the top, 6-7 interleaving

  explicit TgaHeader(std::string_view bytes) {
    const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[at])); };
    const auto word = [&](std::size_t at) { return byte(at) | byte(at + 1) << 8; };
    id_size = byte(0);
    has_palette = byte(1) == 1;
    type = byte(1) > 1 ? 0 : static_cast<int>(byte(2));
    first_entry = word(3);
    entries = has_palette ? word(5) : 0;
    entry_bits = byte(7);
    width = static_cast<int>(word(12));
    height = static_cast<int>(word(14));
    pixel_bits = byte(16);
    descriptor = static_cast<int>(byte(17));
  }

  Kind kind() const { return static_cast<Kind>(type & 3); }
  bool has_runs() const { return type >= 8; }
  std::size_t entry_bytes() const { return (entry_bits + 7) / 8; }
  std::size_t pixel_bytes() const { return (pixel_bits + 7) / 8; }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t palette_at() const { return tga_header_size + id_size; }
  std::size_t pixels_at() const { return palette_at() + entries * entry_bytes(); }
  /// Bytes of a file with these pixels, all of them in the longest runs if there are runs.
  std::size_t least_size() const {
    return pixels_at() +
           (has_runs() ? (pixels() + longest_run - 1) / longest_run * (1 + pixel_bytes()) : pixels() * pixel_bytes());
  }

  /// Why this is not the header of a TGA file; empty if it is one.
  std::string fault() const {
    if ((type & ~8) < 1 || (type & ~8) > 3) return "found no TGA header of a known image type, expected a TGA file";
    const std::size_t sample_bits = kind() == Kind::palette ? entry_bits : pixel_bits;
    const bool known =
        sample_bits == 8 || sample_bits == 15 || sample_bits == 16 || sample_bits == 24 || sample_bits == 32;
    if (!known || (kind() == Kind::grey && pixel_bits != 8 && pixel_bits != 16))
      return fmt::format("found TGA samples of {} bits, which TGA does not have", sample_bits);
    if (kind() == Kind::palette && (entries == 0 || pixel_bits == 0 || pixel_bits > 16))
      return fmt::format("found TGA palette indices of {} bits and {} entries", pixel_bits, entries);
    if (descriptor >> 6 == 3) return "found TGA rows in an order that TGA does not have";
    return {};
  }
};

struct TgaSample {
  Vec3f colour;
  float alpha = 1;
};

/// Reads one file.
class TgaReader {
 public:
  TgaReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file), header_(head_of(bytes)) {}

  StoredPicture read(std::int64_t most_pixels) {
    if (const std::string fault = header_.fault(); !fault.empty()) fail(fault);
    require_read_size(header_.width, header_.height, most_pixels, file_);
    if (bytes_.size() < header_.least_size())
      fail(fmt::format("TGA is cut off: found {} bytes, expected at least {}", bytes_.size(), header_.least_size()));
    picture_.colour = Image<Vec3f>(header_.width, header_.height);
    if (has_alpha()) picture_.alpha = Image<float>(header_.width, header_.height);
    at_ = header_.pixels_at();
    while (placed_ < header_.pixels()) read_pixels();
    drop_empty_alpha();
    return std::move(picture_);
  }

 private:
  using Kind = TgaHeader::Kind;

  TgaHeader head_of(std::string_view bytes) const {
    if (bytes.size() < tga_header_size)
      fail(fmt::format("TGA is cut off: found {} bytes, expected a header of 18", bytes.size()));
    return TgaHeader(bytes);
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(fmt::format("{}: {}", file_, what)); }

  std::size_t byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }

  int alpha_bits() const { return header_.descriptor & 15; }

  std::size_t sample_bits() const { return header_.kind() == Kind::palette ? header_.entry_bits : header_.pixel_bits; }

  bool has_alpha() const {
    if (header_.kind() == Kind::grey) return header_.pixel_bits == 16;
    return sample_bits() == 32 || (sample_bits() == 16 && alpha_bits() > 0);
  }

  /// Some programs leave the fourth byte of each pixel empty, and say so by naming no alpha bits.
  void drop_empty_alpha() {
    const auto alpha = picture_.alpha.pixels();
    if (alpha_bits() == 0 && std::all_of(alpha.begin(), alpha.end(), [](float a) { return a == 0; }))
      picture_.alpha = {};
  }

  /// A grey level, 5 bits for each channel, or 8 bits in the order blue, green, red, alpha.
  TgaSample sample(std::size_t at, std::size_t bits) const {
    const auto unit = [&](std::size_t byte_at) { return static_cast<float>(byte(byte_at)) / 255; };
    const auto fifth = [&](std::size_t word, int shift) { return static_cast<float>(word >> shift & 31) / 31; };
    if (bits == 8) return {Vec3f(unit(at))};
    if (header_.kind() == Kind::grey) return {Vec3f(unit(at)), unit(at + 1)};
    if (bits <= 16) {
      const std::size_t word = byte(at) | byte(at + 1) << 8;
      return {{fifth(word, 10), fifth(word, 5), fifth(word, 0)}, static_cast<float>(word >> 15)};
    }
    return {{unit(at + 2), unit(at + 1), unit(at)}, bits == 32 ? unit(at + 3) : 1};
  }

  /// The pixel that begins at `at`.
  TgaSample pixel(std::size_t at) const {
    if (header_.kind() != Kind::palette) return sample(at, header_.pixel_bits);
    const std::size_t index = header_.pixel_bits > 8 ? byte(at) | byte(at + 1) << 8 : byte(at);
    if (index < header_.first_entry || index - header_.first_entry >= header_.entries)
      fail(fmt::format("a pixel has the palette index {}, expected {} to {}", index, header_.first_entry,
                       header_.first_entry + header_.entries - 1));
    return sample(header_.palette_at() + (index - header_.first_entry) * header_.entry_bytes(), header_.entry_bits);
  }

  /// One run, or one pixel where there are none.
  void read_pixels() {
    require(header_.has_runs() ? 1 : 0);
    const std::size_t head = header_.has_runs() ? byte(at_++) : 0;
    const std::size_t count = head % longest_run + 1;
    const bool repeated = head >= longest_run;
    require((repeated ? 1 : count) * header_.pixel_bytes());
    for (std::size_t i = 0; i < count; ++i) {
      place(pixel(at_));
      if (!repeated || i + 1 == count) at_ += header_.pixel_bytes();
    }
  }

  void require(std::size_t more) const {
    if (bytes_.size() - at_ < more) fail(fmt::format("TGA is cut off at byte {}", bytes_.size()));
  }

  /// The next pixel of the file goes to where its corner says; a run may be longer than what is left.
  void place(const TgaSample& sample) {
    if (placed_ == header_.pixels()) return;
    const bool from_right = (header_.descriptor & 16) != 0, from_top = (header_.descriptor & 32) != 0;
    const int x = from_right ? header_.width - 1 - column_ : column_;
    const int y = from_top ? row_ : header_.height - 1 - row_;
    picture_.colour.at(x, y) = sample.colour;
    if (!picture_.alpha.empty()) picture_.alpha.at(x, y) = sample.alpha;
    ++placed_;
    if (++column_ == header_.width) next_row();
  }

  /// Interleaved files hold every second or fourth row first, then those behind them.
  void next_row() {
    column_ = 0;
    row_ += 1 << (header_.descriptor >> 6);
    if (row_ >= header_.height) row_ = ++first_row_;
  }

  std::string_view bytes_;
  const std::string& file_;
  TgaHeader header_;
  StoredPicture picture_;
  std::size_t at_ = 0;
  std::size_t placed_ = 0;
  int column_ = 0, row_ = 0, first_row_ = 0;  ///< of the next pixel, from the corner where the file begins
};

}  // namespace

StoredPicture read_tga(std::string_view bytes, const std::string& file, std::int64_t most_pixels) {
  return TgaReader(bytes, file).read(most_pixels);
}

bool is_tga(std::string_view bytes) {
  if (bytes.size() < tga_header_size) return false;
  const TgaHeader header(bytes);
  return header.fault().empty() && header.pixels() > 0 && bytes.size() >= header.least_size();
}

}  // namespace ps
