#include "gui/platform/texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace ps::gui {

namespace {

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
  if (id_ != 0) glDeleteTextures(1, &id_);
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)), width_(std::exchange(other.width_, 0)),
      height_(std::exchange(other.height_, 0)), shrunk_(other.shrunk_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(shrunk_, other.shrunk_);
  return *this;
}

void Texture::upload(const Image<Rgb8>& picture) {
  ++changes_of_all;
  if (id_ == 0) {
    glGenTextures(1, &id_);
    glBindTexture(GL_TEXTURE_2D, id_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glBindTexture(GL_TEXTURE_2D, id_);
  width_ = picture.width();
  height_ = picture.height();
  const TileRect all{0, 0, width_, height_};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_BGRA, GL_UNSIGNED_BYTE, four_bytes(picture, all));
}

void Texture::set_shrunk(bool shrunk) const {
  if (id_ == 0 || shrunk_ == shrunk) return;
  shrunk_ = shrunk;
  ++changes_of_all;
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shrunk ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, shrunk ? GL_LINEAR : GL_NEAREST);
}

void Texture::upload(const Image<Rgb8>& picture, const TileRect& rect) {
  if (id_ == 0 || picture.width() != width_ || picture.height() != height_) return upload(picture);
  if (rect.width() <= 0 || rect.height() <= 0) return;
  ++changes_of_all;
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexSubImage2D(GL_TEXTURE_2D, 0, rect.x0, rect.y0, rect.width(), rect.height(), GL_BGRA, GL_UNSIGNED_BYTE,
                  four_bytes(picture, rect));
}

}  // namespace ps::gui
