#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/block_store.h"
#include "base/check.h"

namespace ps {

/// Largest number of pixels that an image may have: 2^28, 16,384 x 16,384.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 28;

/// Throws InputError unless width and height are at least 1 and width * height is within max_image_pixels.
void require_image_size(std::int64_t width, std::int64_t height, const std::string& what);

/// Asks for an image whose pixels hold anything: the caller writes every one of them before any is read.
struct Unfilled {};

/// A picture of any element type, row-major with pixel (0, 0) at the top left. A value: copying copies the pixels.
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const T& fill = T{})
      : width_(width), height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {
    PS_ASSERT(width >= 0 && height >= 0, "image sizes are not negative");
  }
  Image(int width, int height, Unfilled)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    PS_ASSERT(width >= 0 && height >= 0, "image sizes are not negative");
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return pixels_.empty(); }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  /// The pixel in column x and row y, which must lie inside.
  T& at(int x, int y) {
    PS_ASSERT(contains(x, y), "pixel outside the image");
    return pixels_[index(x, y)];
  }
  const T& at(int x, int y) const {
    PS_ASSERT(contains(x, y), "pixel outside the image");
    return pixels_[index(x, y)];
  }
  /// All of row y, from left to right.
  std::span<T> row(int y) { return {pixels_.data() + index(0, y), static_cast<std::size_t>(width_)}; }
  std::span<const T> row(int y) const { return {pixels_.data() + index(0, y), static_cast<std::size_t>(width_)}; }
  std::span<T> pixels() { return pixels_; }
  std::span<const T> pixels() const { return pixels_; }
  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int width_ = 0;
  int height_ = 0;
  std::vector<T, BlockAllocator<T>> pixels_;
};

/// An 8-bit display pixel.
struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb8&) const = default;
};

}  // namespace ps
