#include "hardware/texture_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "hardware/context.h"

namespace ps::hardware {
namespace {

GLint minifying(TextureFilter filter) {
  switch (filter) {
  case TextureFilter::nearest:
    return GL_NEAREST;
  case TextureFilter::bilinear:
    return GL_LINEAR;
  case TextureFilter::mipmap:
    return GL_LINEAR_MIPMAP_NEAREST;
  case TextureFilter::trilinear:
    return GL_LINEAR_MIPMAP_LINEAR;
  }
  return GL_NEAREST;
}

GLint wrapping(TextureWrap wrap) {
  switch (wrap) {
  case TextureWrap::repeat:
    return GL_REPEAT;
  case TextureWrap::clamp:
    return GL_CLAMP_TO_EDGE;
  case TextureWrap::mirror:
    return GL_MIRRORED_REPEAT;
  }
  return GL_REPEAT;
}

void upload(const MipChain& chain, unsigned texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (int level = 0; level < chain.levels(); ++level) {
    const Image<Vec3f>& image = chain.level(level);
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGB32F, image.width(), image.height(), 0, GL_RGB, GL_FLOAT,
                 image.pixels().data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, chain.levels() - 1);
  check_gl("uploading a texture");
}

}  // namespace

TextureStore::~TextureStore() {
  for (const auto& [image, entry] : entries_) glDeleteTextures(1, &entry.texture);
}

void TextureStore::bind(const MipChain& chain, int unit, const DriverFilter& filter, int max_size) {
  const Image<Vec3f>& image = *chain.base;
  if (std::max(image.width(), image.height()) > max_size)
    throw InputError(fmt::format("a texture of {} x {} texels: this graphics driver holds at most {} along a side",
                                 image.width(), image.height(), max_size));
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  Entry& entry = entries_[chain.base.get()];
  if (entry.base.lock() != chain.base || entry.levels != chain.levels()) {
    if (entry.texture != 0) glDeleteTextures(1, &entry.texture);
    entry = {chain.base, chain.levels(), 0};
    glGenTextures(1, &entry.texture);
    upload(chain, entry.texture);
  }
  glBindTexture(GL_TEXTURE_2D, entry.texture);
  const GLint nearest = filter.filter == TextureFilter::nearest ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minifying(filter.filter));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, nearest);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapping(filter.wrap));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapping(filter.wrap));
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(filter.anisotropy));
}

void TextureStore::tidy() {
  std::erase_if(entries_, [](const auto& entry) {
    if (!entry.second.base.expired()) return false;
    glDeleteTextures(1, &entry.second.texture);
    return true;
  });
}

}  // namespace ps::hardware
