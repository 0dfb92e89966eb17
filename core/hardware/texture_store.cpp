#include "hardware/texture_store.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/available_memory.h"
#include "base/check.h"
#include "hardware/context.h"
#include "hardware/least_recent.h"
#include "hardware/level_atlas.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

constexpr std::uint64_t most_texture_bytes = std::uint64_t{1} << 30;

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

void set_parameter(GLenum name, GLint value) { glTexParameteri(GL_TEXTURE_2D, name, value); }

void upload_levels(const MipChain& chain) {
  for (int level = 0; level < chain.levels(); ++level) {
    const Image<Vec3f>& image = chain.level(level);
    glTexImage2D(GL_TEXTURE_2D, level, GL_RGB32F, image.width(), image.height(), 0, GL_RGB, GL_FLOAT,
                 image.pixels().data());
  }
  set_parameter(GL_TEXTURE_MAX_LEVEL, chain.levels() - 1);
}

void upload_atlas(const MipChain& chain, const LevelAtlas& atlas) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, atlas.width, atlas.height, 0, GL_RGB, GL_FLOAT, nullptr);
  for (int level = 0; level < chain.levels(); ++level) {
    const Image<Vec3f>& image = chain.level(level);
    const Vec2i at = atlas.place(level);
    glTexSubImage2D(GL_TEXTURE_2D, 0, at.x, at.y, image.width(), image.height(), GL_RGB, GL_FLOAT,
                    image.pixels().data());
  }
  set_parameter(GL_TEXTURE_MAX_LEVEL, 0);
  set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  set_parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

/// How the driver is to read it.
void set_filter(const Settings& settings, TextureWrap wrap) {
  set_parameter(GL_TEXTURE_MIN_FILTER, minifying(settings.texture_filter));
  set_parameter(GL_TEXTURE_MAG_FILTER, settings.texture_filter == TextureFilter::nearest ? GL_NEAREST : GL_LINEAR);
  set_parameter(GL_TEXTURE_WRAP_S, wrapping(wrap));
  set_parameter(GL_TEXTURE_WRAP_T, wrapping(wrap));
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic"))
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(settings.anisotropy));
}

}  // namespace

TextureStore::~TextureStore() { clear(); }

void TextureStore::clear() {
  for (const auto& [key, entry] : entries_) glDeleteTextures(1, &entry.texture);
  entries_.clear();
}

Vec4<int> TextureStore::bind(const MipChain& chain, int unit, const Settings& settings, int max_size) {
  const bool by_driver = settings.hardware_texturing == HardwareTexturing::driver;
  const LevelAtlas atlas = atlas_of(chain);
  const Image<Vec3f>& base = *chain.base;
  const int longest = by_driver ? std::max(base.width(), base.height()) : std::max(atlas.width, atlas.height);
  if (longest > max_size)
    throw InputError(
        fmt::format("a texture of {} x {} texels: with its smaller levels it needs {} along a side, and this "
                    "graphics driver holds at most {}",
                    base.width(), base.height(), longest, max_size));
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  Entry& entry = entries_[{&base, settings.hardware_texturing}];
  if (entry.base.lock() != chain.base || entry.levels != chain.levels()) {
    if (entry.texture != 0) glDeleteTextures(1, &entry.texture);
    const std::uint64_t bytes =
        by_driver ? base.pixels().size_bytes() + chain.heap_bytes()
                  : sizeof(Vec3f) * static_cast<std::uint64_t>(atlas.width) * static_cast<std::uint64_t>(atlas.height);
    entry = {};
    require_memory(bytes, available_memory(),
                   fmt::format("the {} x {} texels of a texture in the memory of the graphics driver", base.width(),
                               base.height()),
                   "use a smaller one");
    entry = {chain.base, chain.levels(), 0, bytes, 0};
    glGenTextures(1, &entry.texture);
    glBindTexture(GL_TEXTURE_2D, entry.texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (by_driver)
      upload_levels(chain);
    else
      upload_atlas(chain, atlas);
    check_gl("uploading a texture");
  }
  entry.used = ++clock_;
  glBindTexture(GL_TEXTURE_2D, entry.texture);
  if (by_driver) set_filter(settings, raster::wrap_of(chain, settings));
  return atlas.layout;
}

void TextureStore::tidy() {
  std::erase_if(entries_, [](const auto& entry) {
    if (!entry.second.base.expired()) return false;
    glDeleteTextures(1, &entry.second.texture);
    return true;
  });
  std::uint64_t bytes = 0;
  for (const auto& [key, entry] : entries_) bytes += entry.bytes;
  while (bytes > most_texture_bytes && entries_.size() > 1) {
    const auto oldest = least_recent(entries_);
    bytes -= oldest->second.bytes;
    glDeleteTextures(1, &oldest->second.texture);
    entries_.erase(oldest);
  }
}

}  // namespace ps::hardware
