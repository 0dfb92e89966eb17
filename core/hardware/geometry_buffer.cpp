#include "hardware/geometry_buffer.h"

#include <epoxy/gl.h>

#include <vector>

#include "base/check.h"
#include "hardware/context.h"

namespace ps::hardware {

GeometryBuffer::GeometryBuffer(const Framebuffer& target) : shape_(target.shape()) {
  try {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
    std::vector<GLenum> places;
    for (std::size_t i = 0; i < textures_.size(); ++i) {
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D, textures_[i]);
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, shape_.width, shape_.height, 0, GL_RGBA, GL_FLOAT, nullptr);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      places.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
      glFramebufferTexture2D(GL_FRAMEBUFFER, places.back(), GL_TEXTURE_2D, textures_[i], 0);
    }
    const int shared = target.share(static_cast<int>(textures_.size()));
    for (int i = 0; i < shared; ++i) places.push_back(places.back() + 1);
    glDrawBuffers(static_cast<GLsizei>(places.size()), places.data());
    check_gl("making the buffers of deferred shading");
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw InputError("the graphics driver cannot draw into the buffers of deferred shading");
  } catch (...) {
    release();
    throw;
  }
}

GeometryBuffer::~GeometryBuffer() { release(); }

void GeometryBuffer::release() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
}

void GeometryBuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, shape_.width, shape_.height);
}

void GeometryBuffer::clear() const {
  const std::array<float, 4> nothing{0, 0, 0, -1};
  glClearBufferfv(GL_COLOR, 0, nothing.data());
}

void GeometryBuffer::bind_textures(int first_unit) const {
  for (std::size_t i = 0; i < textures_.size(); ++i) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(first_unit) + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_2D, textures_[i]);
  }
}

}  // namespace ps::hardware
