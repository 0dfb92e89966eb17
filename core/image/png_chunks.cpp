#include "image/png_chunks.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "image/exif.h"

namespace ps {
namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t frame_bytes = 12;  ///< length, type and CRC around a chunk's data
constexpr std::string_view last_chunk("\0\0\0\0IEND\xae\x42\x60\x82", frame_bytes);

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
  return value;
}

std::string big_endian_bytes(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string chunk_bytes(std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  return big_endian_bytes(static_cast<std::uint32_t>(data.size())) + body + big_endian_bytes(crc32(body));
}

struct Chunk {
  std::string_view type, data;
  std::size_t begin = 0, end = 0;  ///< in the file, with length and CRC
};

/// Walks over the chunks of one file, checking lengths and CRCs.
class ChunkReader {
 public:
  ChunkReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  [[noreturn]] void fail(const std::string& what) const { throw InputError(fmt::format("{}: {}", file_, what)); }

  Chunk next() {
    Chunk chunk;
    chunk.begin = at_;
    if (bytes_.size() - at_ < frame_bytes) fail(fmt::format("PNG is cut off at byte {}: no IEND chunk", bytes_.size()));
    const std::uint32_t length = big_endian(bytes_.substr(at_));
    chunk.type = bytes_.substr(at_ + 4, 4);
    if (!std::all_of(chunk.type.begin(), chunk.type.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }))
      fail(fmt::format("PNG chunk at byte {} has a damaged name", at_));
    if (length > bytes_.size() - at_ - frame_bytes)
      fail(fmt::format("PNG is cut off: chunk {} at byte {} has {} bytes, but {} are left", chunk.type, at_, length,
                       bytes_.size() - at_ - frame_bytes));
    chunk.data = bytes_.substr(at_ + 8, length);
    const std::uint32_t stored = big_endian(bytes_.substr(at_ + 8 + length));
    const std::uint32_t found = crc32(bytes_.substr(at_ + 4, 4 + std::size_t{length}));
    if (stored != found)
      fail(fmt::format("PNG chunk {} at byte {} is damaged: its CRC is {:08x}, but its bytes give {:08x}", chunk.type,
                       at_, stored, found));
    at_ += frame_bytes + length;
    chunk.end = at_;
    return chunk;
  }

  /// Whether the rest is only a part of the last chunk, or of one that is not needed for the picture.
  bool is_cut_behind_picture() const {
    const std::string_view rest = bytes_.substr(at_);
    if (rest.size() < frame_bytes && last_chunk.starts_with(rest)) return true;
    const bool needless = rest.size() >= 8 && rest[4] >= 'a' && rest[4] <= 'z';
    return needless && (rest.size() < frame_bytes || big_endian(rest) > rest.size() - frame_bytes);
  }

 private:
  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = signature.size();
};

bool allowed_depth(int colour_type, int depth) {
  switch (colour_type) {
  case 0:
    return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
  case 3:
    return depth == 1 || depth == 2 || depth == 4 || depth == 8;
  case 2:
  case 4:
  case 6:
    return depth == 8 || depth == 16;
  }
  return false;
}

PngInfo read_header(const Chunk& chunk, const ChunkReader& reader, const std::string& file) {
  constexpr std::size_t header_size = 13;
  if (chunk.type != "IHDR" || chunk.data.size() != header_size)
    reader.fail("found no IHDR chunk of 13 bytes at the start, expected a PNG header");
  const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(chunk.data[i])); };
  require_image_size(big_endian(chunk.data), big_endian(chunk.data.substr(4)), file);
  PngInfo info;
  info.width = static_cast<int>(big_endian(chunk.data));
  info.height = static_cast<int>(big_endian(chunk.data.substr(4)));
  info.bit_depth = byte(8);
  info.colour_type = byte(9);
  if (!allowed_depth(info.colour_type, info.bit_depth))
    reader.fail(
        fmt::format("found colour type {} with {} bits, which PNG does not have", info.colour_type, info.bit_depth));
  if (byte(10) != 0) reader.fail(fmt::format("found compression method {}, expected 0", byte(10)));
  if (byte(11) != 0) reader.fail(fmt::format("found filter method {}, expected 0", byte(11)));
  if (byte(12) > 1) reader.fail(fmt::format("found interlace method {}, expected 0 or 1", byte(12)));
  return info;
}

std::string utf8_of_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xc0 | code >> 6);
      utf8 += static_cast<char>(0x80 | (code & 0x3f));
    }
  }
  return utf8;
}

/// Reads tEXt and uncompressed iTXt chunks; others are passed over, as are those without a key.
void note_text(const Chunk& chunk, PngInfo& info) {
  if (chunk.type != "tEXt" && chunk.type != "iTXt") return;
  const auto key_end = chunk.data.find('\0');
  if (key_end == std::string_view::npos) return;
  const std::string key(chunk.data.substr(0, key_end));
  std::string_view rest = chunk.data.substr(key_end + 1);
  if (chunk.type == "tEXt") {
    info.texts.push_back({key, utf8_of_latin1(rest)});
    return;
  }
  if (rest.size() < 2 || rest[0] != 0) return;  // compressed
  rest.remove_prefix(2);
  for (int field = 0; field < 2; ++field) {  // language and translated key
    const auto end = rest.find('\0');
    if (end == std::string_view::npos) return;
    rest.remove_prefix(end + 1);
  }
  info.texts.push_back({key, std::string(rest)});
}

bool plain_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c >= 32 && c < 127) || c == '\n'; });
}

std::string text_chunk(const ImageText& text) {
  constexpr std::size_t longest_key = 79;
  const bool key_fits = !text.key.empty() && text.key.size() <= longest_key && plain_ascii(text.key) &&
                        text.key.find('\n') == std::string::npos;
  if (!key_fits)
    throw InputError(fmt::format("found the text key \"{}\", expected 1 to 79 printable ASCII characters", text.key));
  if (text.value.find('\0') != std::string::npos)
    throw InputError(fmt::format("text \"{}\" contains a NUL byte, which PNG does not allow", text.key));
  const std::string head = text.key + '\0';
  if (plain_ascii(text.value)) return chunk_bytes("tEXt", head + text.value);
  return chunk_bytes("iTXt", head + std::string(4, '\0') + text.value);  // not compressed, no language, no translation
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  static const auto table = [] {
    constexpr std::uint32_t polynomial = 0xedb88320;
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? polynomial ^ c >> 1 : c >> 1;
      entries[n] = c;
    }
    return entries;
  }();
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) crc = table[(crc ^ static_cast<unsigned char>(c)) & 0xff] ^ crc >> 8;
  return ~crc;
}

PngInfo check_png(std::string_view bytes, const std::string& file) {
  ChunkReader reader(bytes, file);
  if (bytes.substr(0, signature.size()) != signature) reader.fail("found no PNG signature, expected a PNG file");
  PngInfo info = read_header(reader.next(), reader, file);
  constexpr int palette_type = 3;
  constexpr std::size_t largest_palette = 768;
  bool data_seen = false;
  for (;;) {
    info.ended = !data_seen || !reader.is_cut_behind_picture();
    if (!info.ended) break;
    const Chunk chunk = reader.next();
    info.end = chunk.end;
    if (chunk.type == "IEND") break;
    if (chunk.type == "IHDR") reader.fail("found a second IHDR chunk, expected one");
    if (chunk.type == "PLTE") {
      const std::size_t size = chunk.data.size();
      if (size == 0 || size % 3 != 0 || size > largest_palette)
        reader.fail(fmt::format("found a palette of {} bytes, expected 1 to 256 entries of 3", size));
      if (data_seen || info.palette_entries > 0)
        reader.fail("found a palette out of place, expected one before the data");
      info.palette_entries = static_cast<int>(size / 3);
    }
    if (chunk.type == "IDAT") {
      if (info.colour_type == palette_type && info.palette_entries == 0)
        reader.fail("found palette indices without a palette");
      data_seen = true;
    }
    if (chunk.type == "eXIf") info.orientation = exif_orientation(chunk.data);
    note_text(chunk, info);
  }
  if (!data_seen) reader.fail("found no IDAT chunk, expected picture data");
  return info;
}

std::string png_with_texts(std::string_view png, const std::vector<ImageText>& texts) {
  std::string chunks;
  for (const ImageText& text : texts) chunks += text_chunk(text);
  std::string result(png);
  const std::string file = "PNG in memory";
  result.insert(ChunkReader(png, file).next().end, chunks);
  return result;
}

std::string png_with_padded_palette(std::string_view png, std::uint8_t level) {
  const std::string file = "PNG in memory";
  ChunkReader reader(png, file);
  Chunk chunk = reader.next();
  while (chunk.type != "PLTE" && chunk.type != "IEND") chunk = reader.next();
  PS_ASSERT(chunk.type == "PLTE", "a PNG with a palette");
  std::string entries(chunk.data);
  constexpr std::size_t full = 768;
  entries.resize(full, static_cast<char>(level));
  return std::string(png.substr(0, chunk.begin)) + chunk_bytes("PLTE", entries) + std::string(png.substr(chunk.end));
}

std::string png_with_end(std::string_view png, std::uint8_t filler) {
  constexpr std::size_t further = 64;
  return std::string(png) + chunk_bytes("IDAT", std::string(further, static_cast<char>(filler))) +
         std::string(last_chunk);
}

}  // namespace ps
