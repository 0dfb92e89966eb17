#include "hardware/sample_reader.h"

#include <epoxy/gl.h>

#include "hardware/picture_units.h"

namespace ps::hardware {
namespace {

constexpr int stencil_bits = 8;

/// Puts back what the reader changes and its callers do not set themselves.
class KeptState {
 public:
  KeptState() : scissor_(glIsEnabled(GL_SCISSOR_TEST)) {
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
    glGetIntegerv(GL_SCISSOR_BOX, box_);
    glGetIntegerv(GL_POLYGON_MODE, modes_);
  }
  ~KeptState() {
    glUseProgram(static_cast<GLuint>(program_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glScissor(box_[0], box_[1], box_[2], box_[3]);
    if (scissor_)
      glEnable(GL_SCISSOR_TEST);
    else
      glDisable(GL_SCISSOR_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(modes_[0]));
  }
  KeptState(const KeptState&) = delete;
  KeptState& operator=(const KeptState&) = delete;

 private:
  GLboolean scissor_;
  GLint program_ = 0, viewport_[4]{}, box_[4]{}, modes_[2]{};
};

void draw_one_pixel(int x, int y) {
  for (const GLenum test : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, 1, 1);
  glViewport(x, y, 1, 1);
}

}  // namespace

SampleReader::SampleReader() : program_("whole_picture.glsl", "sample_depths.glsl", Api::desktop, "") {
  glGenQueries(1, &query_);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glGenRenderbuffers(1, &picture_);
  glBindRenderbuffer(GL_RENDERBUFFER, picture_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture_);
}

SampleReader::~SampleReader() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(1, &picture_);
  glDeleteQueries(1, &query_);
}

std::optional<std::vector<float>> SampleReader::depths(const Framebuffer& target, Vec2i pixel) {
  const auto texture = target.depth_samples();
  if (!texture) return {};
  const KeptState kept;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(samples_unit));
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, *texture);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_SAMPLE_MASK);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  draw_one_pixel(0, 0);
  const int samples = target.shape().samples;
  program_.use();
  program_.set("depth_samples", samples_unit);
  program_.set("sampled_pixel", Vec2f(pixel));
  program_.set("sample_count", samples);
  std::vector<float> depths;
  for (int first = 0; first < samples; first += 4) {
    program_.set("first_sample", first);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    Vec4f four;
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &four.x);
    for (int i = 0; i < 4 && first + i < samples; ++i) depths.push_back(four[i]);
  }
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
  return depths;
}

// The viewport is the pixel itself, so that no sample of a neighbour is counted.
std::vector<int> SampleReader::stencils(const Framebuffer& target, Vec2i pixel) {
  const KeptState kept;
  target.bind();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glEnable(GL_SAMPLE_MASK);
  draw_one_pixel(pixel.x, pixel.y);
  program_.use();
  program_.set("sample_count", 0);  // it covers the pixel, and reads nothing
  std::vector<int> stencils;
  for (int sample = 0; sample < target.shape().samples; ++sample) {
    glSampleMaski(0, 1u << sample);
    int stencil = 0;
    for (int bit = 0; bit < stencil_bits; ++bit) {
      glStencilFunc(GL_EQUAL, 1 << bit, 1u << bit);
      glBeginQuery(GL_SAMPLES_PASSED, query_);
      glDrawArrays(GL_TRIANGLES, 0, 3);
      glEndQuery(GL_SAMPLES_PASSED);
      GLuint passed = 0;
      glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &passed);
      if (passed > 0) stencil |= 1 << bit;
    }
    stencils.push_back(stencil);
  }
  glDisable(GL_SAMPLE_MASK);
  return stencils;
}

}  // namespace ps::hardware
