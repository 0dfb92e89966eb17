#include "image/codec.h"

#include <cstdlib>
#include <limits>
#include <memory>

#include <fmt/format.h>

#include "image/read_limit.h"

namespace {

/// Largest block that a decode in this thread may ask for: a small file may unpack to any size, but never to more than
/// its header promises.
thread_local std::size_t largest_block = 0;

/// Zeros: the decoder of JPEG reads tables that a damaged file does not define.
void* limited_malloc(std::size_t size) { return size <= largest_block ? std::calloc(1, size) : nullptr; }
void* limited_realloc(void* block, std::size_t size) {
  return size <= largest_block ? std::realloc(block, size) : nullptr;
}

}  // namespace

#define STBI_MALLOC(size) limited_malloc(size)
#define STBI_REALLOC(block, size) limited_realloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS (1 << 28)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace ps {
namespace {

[[noreturn]] void fail(const std::string& file) {
  const char* reason = stbi_failure_reason();
  throw InputError(fmt::format("{}: the picture cannot be decoded ({})", file, reason ? reason : "unknown reason"));
}

/// `samples` holds red, green, blue and opacity.
template <class Sample>
StoredPicture unit_picture(const Sample* samples, int width, int height, bool has_alpha) {
  constexpr float largest = std::numeric_limits<Sample>::max();
  StoredPicture picture{Image<Vec3f>(width, height), {}, {}};
  if (has_alpha) picture.alpha = Image<float>(width, height);
  for (std::size_t i = 0; i < picture.colour.pixels().size(); ++i, samples += 4) {
    picture.colour.pixels()[i] = Vec3f(samples[0], samples[1], samples[2]) / largest;
    if (has_alpha) picture.alpha.pixels()[i] = static_cast<float>(samples[3]) / largest;
  }
  return picture;
}

}  // namespace

StoredPicture stb_decode(std::string_view bytes, const std::string& file, std::int64_t most_pixels) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(fmt::format("{}: has {} bytes, expected under 2 GiB", file, bytes.size()));
  const int size = static_cast<int>(bytes.size());
  constexpr std::size_t tables = std::size_t{1} << 20;
  largest_block = tables;
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) fail(file);
  require_read_size(width, height, most_pixels, file);
  // Four samples of two bytes, doubled for filter bytes, rows padded to whole blocks and growing buffers; compressed
  // bytes are gathered in a block of their own.
  constexpr std::size_t bytes_per_pixel = 16;
  constexpr std::size_t padding = 64;
  largest_block =
      tables + 2 * bytes.size() +
      bytes_per_pixel * (static_cast<std::size_t>(width) + padding) * (static_cast<std::size_t>(height) + padding);
  constexpr int wanted = 4;
  const auto has_alpha = [&] { return channels == 2 || channels == 4; };
  if (stbi_is_16_bit_from_memory(data, size)) {
    const std::unique_ptr<stbi_us, void (*)(void*)> samples(
        stbi_load_16_from_memory(data, size, &width, &height, &channels, wanted), stbi_image_free);
    if (!samples) fail(file);
    return unit_picture(samples.get(), width, height, has_alpha());
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> samples(
      stbi_load_from_memory(data, size, &width, &height, &channels, wanted), stbi_image_free);
  if (!samples) fail(file);
  return unit_picture(samples.get(), width, height, has_alpha());
}

std::string stb_encode_png(const Image<Rgb8>& levels) {
  static_assert(sizeof(Rgb8) == 3, "pixels lie without gaps");
  // The lowest level that stb has: in seven tenths of the time, a file that is 2 % larger.
  [[maybe_unused]] static const int level = stbi_write_png_compression_level = 5;
  int size = 0;
  const std::unique_ptr<unsigned char, void (*)(void*)> bytes(
      stbi_write_png_to_mem(reinterpret_cast<const unsigned char*>(levels.pixels().data()), 3 * levels.width(),
                            levels.width(), levels.height(), 3, &size),
      std::free);
  PS_ASSERT(bytes, "memory for a PNG file");
  return {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
}

}  // namespace ps
