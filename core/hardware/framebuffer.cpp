#include "hardware/framebuffer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "base/check.h"
#include "hardware/context.h"

namespace ps::hardware {
namespace {

constexpr std::array<GLenum, 4> formats{GL_RGBA32F, GL_RGBA32I, GL_RGBA32F, GL_RGBA32F};

/// No more than this, a shader writes where triangles have no numbers. Real weights may be below 0, where the centre of
/// a pixel with several samples lies beyond an edge.
constexpr float without_weights = -1e29f;

GLenum depth_format(const FramebufferShape& shape) {
  switch (shape.depth) {
  case DepthStore::float32:
    return shape.stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  case DepthStore::unorm24:
    return shape.stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
  case DepthStore::unorm16:
    return GL_DEPTH_COMPONENT16;
  }
  return GL_DEPTH_COMPONENT32F;
}

GLenum depth_place(const FramebufferShape& shape) {
  return shape.stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

template <class Pixel>
std::vector<Pixel> read_pixels(unsigned picture, const FramebufferShape& shape, GLenum format, GLenum type) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height));
  glReadBuffer(GL_COLOR_ATTACHMENT0 + picture);
  glReadPixels(0, 0, shape.width, shape.height, format, type, pixels.data());
  return pixels;
}

}  // namespace

Framebuffer::Framebuffer(const FramebufferShape& shape) : shape_(shape) {
  try {
    make(drawn_, shape.samples);
    if (shape.samples > 1) make(resolved_, 1);
  } catch (...) {
    release();
    throw;
  }
}

void Framebuffer::make(Pictures& pictures, int samples) const {
  glGenFramebuffers(1, &pictures.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, pictures.framebuffer);
  const auto attach = [&](unsigned& buffer, GLenum format, GLenum place) {
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, shape_.width, shape_.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    GLint given = 0;
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
    if (std::max(given, 1) != samples)
      throw InputError(fmt::format("this graphics driver does not offer {} samples per pixel", samples));
  };
  std::array<GLenum, most_pictures> places{};
  for (std::size_t i = 0; i < count(); ++i) {
    places[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    if (i == 0 || samples == 1)
      attach(pictures.buffers[i], formats[i], places[i]);
    else if (!attach_texture(pictures.textures[i - 1], formats[i], places[i], samples))
      throw InputError(fmt::format("this graphics driver does not offer channels with {} samples per pixel", samples));
  }
  if (samples == 1 || !attach_texture(pictures.depth_texture, depth_format(shape_), depth_place(shape_), samples))
    attach(pictures.depth, depth_format(shape_), depth_place(shape_));
  glDrawBuffers(static_cast<GLsizei>(count()), places.data());
  // All drivers draw into pictures of these formats, so what is wrong is their size.
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    forget_errors();
    throw InputError(fmt::format("a picture of {} x {} pixels: this graphics driver has no room to draw it; choose a "
                                 "smaller size",
                                 shape_.width, shape_.height));
  }
  check_gl("making a picture to draw into");
}

// A shader can read single samples of a texture, and of no other buffer.
bool Framebuffer::attach_texture(unsigned& texture, unsigned format, unsigned place, int samples) const {
  const bool depth = place == depth_place(shape_);
  GLint most = 0;
  glGetIntegerv(depth ? GL_MAX_DEPTH_TEXTURE_SAMPLES : GL_MAX_COLOR_TEXTURE_SAMPLES, &most);
  if (most < samples) return false;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, shape_.width, shape_.height, GL_TRUE);
  GLint given = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &given);
  if (given != samples) {
    glDeleteTextures(1, &texture);
    texture = 0;
    return false;
  }
  glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
  return true;
}

std::optional<unsigned> Framebuffer::depth_samples() const {
  if (drawn_.depth_texture == 0) return {};
  return drawn_.depth_texture;
}

Framebuffer::~Framebuffer() { release(); }

void Framebuffer::release() {
  for (const Pictures* pictures : {&drawn_, &resolved_}) {
    glDeleteFramebuffers(1, &pictures->framebuffer);
    glDeleteRenderbuffers(1, &pictures->depth);
    glDeleteTextures(1, &pictures->depth_texture);
    glDeleteTextures(static_cast<GLsizei>(pictures->textures.size()), pictures->textures.data());
    glDeleteRenderbuffers(static_cast<GLsizei>(pictures->buffers.size()), pictures->buffers.data());
  }
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_.framebuffer);
  glViewport(0, 0, shape_.width, shape_.height);
}

int Framebuffer::share(int first) const {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, depth_place(shape_), GL_RENDERBUFFER, drawn_.depth);
  for (std::size_t i = 1; i < count(); ++i)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER,
                              GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(first) + static_cast<GLenum>(i) - 1,
                              GL_RENDERBUFFER, drawn_.buffers[i]);
  return static_cast<int>(count()) - 1;
}

void Framebuffer::resolve() const {
  if (shape_.samples == 1) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
  constexpr GLenum colour = GL_COLOR_ATTACHMENT0;
  glReadBuffer(colour);
  glDrawBuffers(1, &colour);
  glBlitFramebuffer(0, 0, shape_.width, shape_.height, 0, 0, shape_.width, shape_.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  check_gl("resolving samples");
}

void Framebuffer::bind_resolved() const {
  glBindFramebuffer(GL_FRAMEBUFFER, shape_.samples > 1 ? resolved_.framebuffer : drawn_.framebuffer);
  const std::array<GLenum, most_pictures> places{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                                 GL_COLOR_ATTACHMENT3};
  glDrawBuffers(static_cast<GLsizei>(count()), places.data());
  glViewport(0, 0, shape_.width, shape_.height);
}

void Framebuffer::clear(const Vec3d& background, float depth) const {
  const Vec3f colour(background);
  const std::array<float, 4> rgba{colour.x, colour.y, colour.z, 1};
  glClearBufferfv(GL_COLOR, 0, rgba.data());
  if (shape_.stencil)
    glClearBufferfi(GL_DEPTH_STENCIL, 0, depth, 0);
  else
    glClearBufferfv(GL_DEPTH, 0, &depth);
  if (!shape_.channels) return;
  const std::array<GLint, 4> nothing{-1, -1, std::bit_cast<GLint>(std::numeric_limits<float>::infinity()),
                                     std::bit_cast<GLint>(-1.0f)};
  const std::array<float, 4> zeros{};
  glClearBufferiv(GL_COLOR, 1, nothing.data());
  glClearBufferfv(GL_COLOR, 2, zeros.data());
  glClearBufferfv(GL_COLOR, 3, zeros.data());
}

void Framebuffer::resolve_pixel(Vec2i pixel) const {
  if (shape_.samples == 1) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.framebuffer);
  const int x = pixel.x, y = pixel.y;
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glBlitFramebuffer(x, y, x + 1, y + 1, x, y, x + 1, y + 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Vec4f Framebuffer::read_pixel(Vec2i pixel) const {
  Vec4f colour;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, shape_.samples > 1 ? resolved_.framebuffer : drawn_.framebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(pixel.x, pixel.y, 1, 1, GL_RGBA, GL_FLOAT, &colour.x);
  return colour;
}

float Framebuffer::read_depth(Vec2i pixel) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
  float depth = 0;
  glReadPixels(pixel.x, pixel.y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  return depth;
}

int Framebuffer::read_stencil(Vec2i pixel) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
  GLuint count = 0;
  glReadPixels(pixel.x, pixel.y, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_INT, &count);
  return static_cast<int>(count);
}

void Framebuffer::read(Frame& frame) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, shape_.samples > 1 ? resolved_.framebuffer : drawn_.framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, shape_.width, shape_.height, GL_RGB, GL_FLOAT, frame.colour.pixels().data());
  check_gl("reading the picture");
  if (!shape_.channels) return;
  const auto ids = read_pixels<std::array<std::int32_t, 4>>(1, shape_, GL_RGBA_INTEGER, GL_INT);
  const auto normals = read_pixels<Vec4f>(2, shape_, GL_RGBA, GL_FLOAT);
  const auto weights = read_pixels<Vec4f>(3, shape_, GL_RGBA, GL_FLOAT);
  check_gl("reading the picture");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool seen = ids[i][0] >= 0;
    if (!frame.ids.empty()) frame.ids.pixels()[i] = {ids[i][0], ids[i][1]};
    if (!frame.depth.empty()) frame.depth.pixels()[i] = std::bit_cast<float>(ids[i][2]);
    if (!frame.mip.empty()) frame.mip.pixels()[i] = std::bit_cast<float>(ids[i][3]);
    if (!frame.normal.empty()) frame.normal.pixels()[i] = Vec3f(normals[i]);
    if (!frame.facing.empty()) frame.facing.pixels()[i] = normals[i].w;
    if (!frame.barycentric.empty() && seen && weights[i].x > without_weights)
      frame.barycentric.pixels()[i] = {weights[i].x, weights[i].y, 1 - weights[i].x - weights[i].y};
    if (!frame.uv.empty()) frame.uv.pixels()[i] = {weights[i].z, weights[i].w};
  }
}

}  // namespace ps::hardware
