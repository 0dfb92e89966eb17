#include "image/pnm.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "image/pnm_text.h"

namespace ps {
namespace {

struct Size {
  int width = 0, height = 0;
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

Size read_size(PnmText& text, const std::string& file, std::int64_t most_pixels) {
  constexpr std::int64_t longest = std::numeric_limits<int>::max();
  const std::int64_t width = text.integer(1, longest, "width");
  const std::int64_t height = text.integer(1, longest, "height");
  require_read_size(width, height, most_pixels, file);
  return {static_cast<int>(width), static_cast<int>(height)};
}

/// Before any memory is asked for.
void require_bytes(const PnmText& text, std::size_t found, std::size_t expected) {
  if (found < expected)
    text.fail(fmt::format("{} bytes of pixels", found), fmt::format("{} (is the file cut off?)", expected));
}

/// Calls next() for each sample and puts the results in place.
template <class Next>
Image<Vec3f> collect(Size size, int channels, Next next) {
  Image<Vec3f> image(size.width, size.height);
  for (Vec3f& pixel : image.pixels()) {
    pixel.r = next();
    pixel.g = channels == 1 ? pixel.r : next();
    pixel.b = channels == 1 ? pixel.r : next();
  }
  return image;
}

Image<Vec3f> read_ascii(PnmText& text, Size size, int channels, int largest) {
  const std::size_t samples = size.pixels() * static_cast<std::size_t>(channels);
  require_bytes(text, text.left(), 2 * samples);  // a digit and the white space before it
  return collect(size, channels,
                 [&] { return static_cast<float>(text.integer(0, largest, "sample")) / static_cast<float>(largest); });
}

Image<Vec3f> read_binary(PnmText& text, Size size, int channels, int largest) {
  constexpr int largest_byte = 255;
  const std::size_t sample_bytes = largest > largest_byte ? 2 : 1;
  const std::string_view data = text.rest();
  require_bytes(text, data.size(), size.pixels() * static_cast<std::size_t>(channels) * sample_bytes);
  std::size_t at = 0;
  return collect(size, channels, [&] {
    int value = static_cast<unsigned char>(data[at++]);
    if (sample_bytes == 2) value = value << 8 | static_cast<unsigned char>(data[at++]);
    if (value > largest) text.fail(fmt::format("sample {}", value), fmt::format("at most {}", largest));
    return static_cast<float>(value) / static_cast<float>(largest);
  });
}

float float_at(std::string_view data, std::size_t at, bool little_endian) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto byte = static_cast<std::uint32_t>(static_cast<unsigned char>(data[at + i]));
    bits |= byte << (8 * (little_endian ? i : 3 - i));
  }
  return std::bit_cast<float>(bits);
}

void append_float(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

/// The header, then the rows from the bottom up.
template <class Pixel, class Append>
std::string pfm_of(std::string_view magic, const Image<Pixel>& image, Append append) {
  std::string bytes = fmt::format("{}\n{} {}\n-1.0\n", magic, image.width(), image.height());
  bytes.reserve(bytes.size() + image.pixels().size_bytes());
  for (int y = image.height() - 1; y >= 0; --y)
    for (const Pixel& pixel : image.row(y)) append(bytes, pixel);
  return bytes;
}

std::string comment(const ImageText& text) {
  std::string line = fmt::format("# {}: {}", text.key, text.value);
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  return line + '\n';
}

}  // namespace

Image<Vec3f> read_pnm(std::string_view bytes, const std::string& file, std::int64_t most_pixels) {
  PnmText text(bytes, file);
  const std::string_view magic = text.word("P2, P3, P5 or P6");
  const bool ascii = magic == "P2" || magic == "P3";
  const bool binary = magic == "P5" || magic == "P6";
  if (!ascii && !binary) text.fail("another kind of file", "a PGM or PPM file that begins with P2, P3, P5 or P6");
  const int channels = magic == "P2" || magic == "P5" ? 1 : 3;
  const Size size = read_size(text, file, most_pixels);
  constexpr std::int64_t largest_allowed = 65535;
  const int largest = static_cast<int>(text.integer(1, largest_allowed, "largest value"));
  return ascii ? read_ascii(text, size, channels, largest) : read_binary(text, size, channels, largest);
}

StoredPicture read_pfm(std::string_view bytes, const std::string& file, std::int64_t most_pixels) {
  PnmText text(bytes, file);
  const std::string_view magic = text.word("PF or Pf");
  if (magic != "PF" && magic != "Pf") text.fail("another kind of file", "a PFM file that begins with PF or Pf");
  const std::size_t channels = magic == "PF" ? 3 : 1;
  const Size size = read_size(text, file, most_pixels);
  const double scale = text.real("scale");
  if (scale == 0) text.fail("a scale of 0", "a negative (little-endian) or positive (big-endian) scale");
  const std::string_view data = text.rest();
  require_bytes(text, data.size(), size.pixels() * channels * sizeof(float));

  StoredPicture picture{Image<Vec3f>(size.width, size.height), {}, {}};
  if (std::abs(scale) != 1)
    picture.notes.push_back(fmt::format("has the PFM scale {}, which is not applied", std::abs(scale)));
  std::size_t at = 0;
  const auto next = [&] {
    at += sizeof(float);
    return float_at(data, at - sizeof(float), scale < 0);
  };
  for (int y = size.height - 1; y >= 0; --y) {  // rows are stored from the bottom up
    for (Vec3f& pixel : picture.colour.row(y)) {
      pixel.r = next();
      pixel.g = channels == 1 ? pixel.r : next();
      pixel.b = channels == 1 ? pixel.r : next();
    }
  }
  return picture;
}

std::string ppm_bytes(const Image<Rgb8>& levels, const SaveOptions& options) {
  const bool ascii = options.pnm == PnmForm::ascii;
  std::string bytes = ascii ? "P3\n" : "P6\n";
  for (const ImageText& text : options.texts) bytes += comment(text);
  bytes += fmt::format("{} {}\n255\n", levels.width(), levels.height());
  if (ascii) {
    for (const Rgb8 c : levels.pixels()) fmt::format_to(std::back_inserter(bytes), "{} {} {}\n", c.r, c.g, c.b);
  } else {
    static_assert(sizeof(Rgb8) == 3, "pixels lie without gaps");
    bytes.append(reinterpret_cast<const char*>(levels.pixels().data()), levels.pixels().size_bytes());
  }
  return bytes;
}

std::string pfm_bytes(const Image<Vec3f>& linear) {
  return pfm_of("PF", linear, [](std::string& bytes, const Vec3f& pixel) {
    for (int i = 0; i < 3; ++i) append_float(bytes, pixel[i]);
  });
}

std::string pfm_bytes(const Image<float>& numbers) { return pfm_of("Pf", numbers, append_float); }

}  // namespace ps
