#include <epoxy/gl.h>
#include <fmt/format.h>

#include "hardware/sample_reader.h"
#include "hardware/story_drawer.h"

namespace ps::hardware {

// The triangle's own depths: drawn again by the picture's program into a depth buffer of the same format, where each
// replaces what is there.
StoryDrawer::SampleValues StoryDrawer::look_at_values(unsigned among, const std::function<void()>& draw) {
  if (!shop_.sample_reader) shop_.sample_reader = std::make_unique<SampleReader>();
  SampleValues values;
  if (shop_.target->shape().stencil) {
    values.stencil = shop_.sample_reader->stencils(*shop_.target, pixel_);
    for (int& stencil : values.stencil) stencil &= static_cast<int>(stencil_mask());
  }
  if (plan_.settings.visibility != Visibility::depth_buffer) return values;
  const auto stored = shop_.sample_reader->depths(*shop_.target, pixel_);
  if (!stored) return values;
  shop_.story->bind();
  glDisable(GL_STENCIL_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  glEnable(GL_SAMPLE_MASK);
  glSampleMaski(0, among);
  draw();
  glDisable(GL_SAMPLE_MASK);
  if (const auto own = shop_.sample_reader->depths(*shop_.story, pixel_)) {
    values.stored = *stored;
    values.own = *own;
  }
  return values;
}

CoverageEvent StoryDrawer::samples_event(const NearTriangle& triangle, unsigned covered, const Outcome& outcome) const {
  CoverageEvent event;
  event.id = triangle.id;
  event.covered = true;
  event.tests = samples();
  std::string each;
  for (int sample = 0; sample < samples(); ++sample) {
    const auto at = static_cast<std::size_t>(sample);
    const bool written = ((outcome.written >> sample) & 1u) != 0;
    if (written) event.values.push_back(sample);
    if (((covered >> sample) & 1u) == 0) continue;
    const SampleValues& values = outcome.samples;
    std::string what;
    if (!values.own.empty()) what += fmt::format(", depth {:.9g}, stored {:.9g}", values.own[at], values.stored[at]);
    if (!values.stencil.empty()) what += fmt::format(", stencil {}", values.stencil[at]);
    if (!what.empty())
      each += fmt::format(". Sample {}{}: {}", sample, written ? "" : " (not written)", what.substr(2));
  }
  event.how = fmt::format("{} of {} samples are written{}", event.values.size(), event.tests, each);
  return event;
}

}  // namespace ps::hardware
