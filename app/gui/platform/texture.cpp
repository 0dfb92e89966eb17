#include "gui/platform/texture.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gui/platform/graphics.h"

namespace ps::gui {

namespace {

constexpr float unequal_below = 4;  // times: above it a pixel more or less is not seen

std::uint64_t changes_of_all = 0;

/// The pixels in the format that drivers keep themselves, so that they only copy. Good until the next call.
const void* four_bytes(const Image<Rgb8>& picture, const TileRect& rect) {
  struct Bgra8 {
    std::uint8_t b, g, r, a;
  };
  static std::vector<Bgra8> pixels;
  pixels.resize(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
  auto to = pixels.begin();
  for (int y = rect.y0; y < rect.y1; ++y) {
    const auto row = picture.row(y).subspan(static_cast<std::size_t>(rect.x0), static_cast<std::size_t>(rect.width()));
    to = std::transform(row.begin(), row.end(), to, [](Rgb8 p) { return Bgra8{p.b, p.g, p.r, 255}; });
  }
  return pixels.data();
}

}  // namespace

std::uint64_t Texture::changes() { return changes_of_all; }

Texture::~Texture() {
  if (id_ && Graphics::current()) Graphics::current()->destroy_texture(id_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, ImTextureID{})), width_(std::exchange(other.width_, 0)),
      height_(std::exchange(other.height_, 0)), smooth_(other.smooth_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(smooth_, other.smooth_);
  return *this;
}

void Texture::upload(const Image<Rgb8>& picture) {
  ++changes_of_all;
  Graphics& graphics = *Graphics::current();
  if (!id_ || picture.width() != width_ || picture.height() != height_) {
    id_ = graphics.sized_texture(id_, {picture.width(), picture.height()});
    if (smooth_) graphics.set_smooth(id_, true);
  }
  width_ = picture.width();
  height_ = picture.height();
  const TileRect all{0, 0, width_, height_};
  graphics.upload(id_, all, four_bytes(picture, all));
}

void Texture::set_smooth(bool smooth) const {
  if (!id_ || smooth_ == smooth) return;
  smooth_ = smooth;
  ++changes_of_all;
  Graphics::current()->set_smooth(id_, smooth);
}

void Texture::upload(const Image<Rgb8>& picture, const TileRect& rect) {
  if (!id_ || picture.width() != width_ || picture.height() != height_) return upload(picture);
  if (rect.width() <= 0 || rect.height() <= 0) return;
  ++changes_of_all;
  Graphics::current()->upload(id_, rect, four_bytes(picture, rect));
}

void add_plain_texture(ImDrawList& list, const Texture& texture, ImVec2 min, ImVec2 max) {
  Graphics& graphics = *Graphics::current();
  const float enlarged = (max.x - min.x) / static_cast<float>(std::max(texture.width(), 1));
  const bool unequal = enlarged > 1 && enlarged < unequal_below && enlarged != std::round(enlarged);
  const bool even = unequal && graphics.add_even(list, texture.id(), min, max);
  texture.set_smooth(even || enlarged < 1);
  if (!even) graphics.add_plain(list, texture.id(), min, max);
}

}  // namespace ps::gui
