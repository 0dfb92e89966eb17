#include "hardware/corner_capture.h"

#include <epoxy/gl.h>

#include "hardware/context.h"

namespace ps::hardware {

CapturedTriangle capture_corners(const std::function<void()>& draw) {
  CapturedTriangle corners;
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof(corners), nullptr, GL_STREAM_READ);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_TRIANGLES);
  draw();
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof(corners), corners.data());
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glDeleteBuffers(1, &buffer);
  check_gl("keeping the vertices of a triangle");
  return corners;
}

}  // namespace ps::hardware
