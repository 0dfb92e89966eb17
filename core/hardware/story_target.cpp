#include "hardware/story_target.h"

#include <epoxy/gl.h>

#include "base/check.h"
#include "hardware/context.h"

namespace ps::hardware {

StoryTarget::StoryTarget(const Shape& shape) : shape_(shape) {
  try {
    make(single_, 1);
    if (shape.samples > 1) make(drawn_, shape.samples);
  } catch (...) {
    release();
    throw;
  }
}

void StoryTarget::make(Picture& picture, int samples) const {
  glGenFramebuffers(1, &picture.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer);
  glGenRenderbuffers(1, &picture.buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, picture.buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, GL_RGBA32F, shape_.width, shape_.height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture.buffer);
  const GLenum place = GL_COLOR_ATTACHMENT0;
  glDrawBuffers(1, &place);
  check_gl("making a picture for the story of a pixel");
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw InputError("the graphics driver cannot draw into pictures of 32-bit floats");
}

StoryTarget::~StoryTarget() { release(); }

void StoryTarget::release() {
  for (const Picture* picture : {&drawn_, &single_}) {
    glDeleteFramebuffers(1, &picture->framebuffer);
    glDeleteRenderbuffers(1, &picture->buffer);
  }
}

void StoryTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, shape_.samples > 1 ? drawn_.framebuffer : single_.framebuffer);
  glViewport(0, 0, shape_.width, shape_.height);
}

void StoryTarget::bind_single() const {
  glBindFramebuffer(GL_FRAMEBUFFER, single_.framebuffer);
  glViewport(0, 0, shape_.width, shape_.height);
}

void StoryTarget::clear() {
  const std::array<float, 4> zeros{};
  glClearBufferfv(GL_COLOR, 0, zeros.data());
}

Vec4f StoryTarget::read_single(Vec2i pixel) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, single_.framebuffer);
  Vec4f value;
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(pixel.x, pixel.y, 1, 1, GL_RGBA, GL_FLOAT, &value.x);
  return value;
}

Vec4f StoryTarget::read_sample(Vec2i pixel) const {
  if (shape_.samples == 1) return read_single(pixel);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.framebuffer);
  const int x = pixel.x, y = pixel.y;
  glBlitFramebuffer(x, y, x + 1, y + 1, x, y, x + 1, y + 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return read_single(pixel) * static_cast<float>(shape_.samples);
}

}  // namespace ps::hardware
