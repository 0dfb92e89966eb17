#include <epoxy/gl.h>

#include <array>

#include "hardware/definitions.h"
#include "hardware/picture_units.h"
#include "hardware/story_drawer.h"

namespace ps::hardware {

Program& StoryDrawer::story_program(std::size_t surface) {
  const std::string key =
      hardware::definitions(plan_, plan_.surfaces.list[surface], shop_.driver().clip_control, ProgramUse::story);
  return program_of("vertex.glsl", "fragment.glsl", key, captured_outputs);
}

Program& StoryDrawer::deferred_story_program() {
  return program_of("whole_picture.glsl", "deferred.glsl",
                    deferred_definitions(plan_, shop_.driver().clip_control, ProgramUse::story));
}

// Nothing is tested and all that is drawn is written.
void StoryDrawer::begin_asking() const {
  shop_.story->bind();
  for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_BLEND}) glDisable(test);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (samples() > 1) glEnable(GL_SAMPLE_MASK);
}

Vec4f StoryDrawer::page(const Asked& asked, Page page) const {
  asked.program.use();
  asked.program.set("story_page", static_cast<int>(page));
  return value_written(asked.covered, asked.draw);
}

// The other samples hold zeros: the mean of all is a power of two smaller than the value, which costs no bits.
Vec4f StoryDrawer::value_written(unsigned covered, const std::function<void()>& draw) const {
  begin_asking();
  glSampleMaski(0, covered & (~covered + 1));  // the lowest of them
  const std::array<float, 4> zeros{};
  glClearBufferfv(GL_COLOR, 0, zeros.data());
  draw();
  glDisable(GL_SAMPLE_MASK);
  shop_.story->resolve_pixel(pixel_);
  return shop_.story->read_pixel(pixel_) * static_cast<float>(samples());
}

}  // namespace ps::hardware
