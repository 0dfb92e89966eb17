#include <epoxy/gl.h>

#include <cstddef>

#include "hardware/canvas_shapes.h"
#include "hardware/picture_drawer.h"

namespace ps::hardware {
namespace {

/// How a shape's colour is mixed with that below it (image/mixing.h).
void set_blend(Blend blend) {
  switch (blend) {
  case Blend::replace:
    glBlendFunc(GL_ONE, GL_ZERO);
    return;
  case Blend::additive:
    glBlendFunc(GL_ONE, GL_ONE);
    return;
  case Blend::subtractive:
    glBlendFunc(GL_DST_COLOR, GL_ZERO);
    return;
  }
}

}  // namespace

// On the finished picture, whose pixels have one sample each: shapes on the canvas have no depth.
void PictureDrawer::draw_canvas(const std::function<void(const CanvasDraw&)>& draw_one) {
  const CanvasShapes shapes = canvas_shapes(plan_, shop_.driver().subpixel_bits);
  if (shapes.corners.empty()) return;
  shop_.target->bind_resolved();
  for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE}) glDisable(test);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  Program& program = program_of("canvas_vertex.glsl", "canvas_fragment.glsl", "");
  program.use();
  program.set("canvas_size",
              Vec2f(static_cast<float>(plan_.viewport.columns), static_cast<float>(plan_.viewport.rows)));
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shapes.corners.size() * sizeof(CanvasCorner)),
               shapes.corners.data(), GL_STREAM_DRAW);
  for (GLuint place = 0; place < stream_count; ++place) glDisableVertexAttribArray(place);
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(CanvasCorner), nullptr);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes the offset as a pointer
  const auto* colours = reinterpret_cast<const void*>(offsetof(CanvasCorner, colour));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(CanvasCorner), colours);
  glEnablei(GL_BLEND, 0);
  glBlendEquation(GL_FUNC_ADD);
  for (const CanvasDraw& draw : shapes.draws) draw_one(draw);
  glDisable(GL_BLEND);
  glDeleteBuffers(1, &buffer);
}

void PictureDrawer::draw_shape(const CanvasDraw& draw) {
  set_blend(draw.blend);
  glDrawArrays(draw.lines ? GL_LINES : GL_TRIANGLES, static_cast<GLint>(draw.first), static_cast<GLsizei>(draw.count));
}

}  // namespace ps::hardware
