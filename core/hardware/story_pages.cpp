#include <epoxy/gl.h>

#include <bit>

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

Vec4f StoryDrawer::page(Program& program, Page page, unsigned covered, const std::function<void()>& draw) const {
  begin_asking();
  glSampleMaski(0, covered & (~covered + 1));  // the lowest of them
  StoryTarget::clear();
  program.use();
  program.set("story_page", static_cast<int>(page));
  draw();
  glDisable(GL_SAMPLE_MASK);
  return shop_.story->read_sample(pixel_);
}

}  // namespace ps::hardware
