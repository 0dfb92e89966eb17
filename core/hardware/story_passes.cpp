#include <epoxy/gl.h>

#include <bit>

#include "base/stop.h"
#include "hardware/picture_units.h"
#include "hardware/story_drawer.h"

namespace ps::hardware {

void StoryDrawer::bind_picture(const DrawPass& pass) const {
  if (pass.kind == DrawPass::Kind::geometry)
    shop_.geometry->bind();
  else
    shop_.target->bind();
}

Vec3d StoryDrawer::colour_now() const {
  shop_.target->resolve_pixel(pixel_);
  return resolved_colour();
}

Vec3d StoryDrawer::resolved_colour() const { return vector_of(shop_.target->read_pixel(pixel_)); }

std::optional<double> StoryDrawer::depth_now() const {
  if (samples() > 1 || plan_.settings.visibility != Visibility::depth_buffer) return {};
  return static_cast<double>(shop_.target->read_depth(pixel_));
}

// How many of the samples, given as bits, pass all tests.
unsigned StoryDrawer::count_samples(unsigned among, const std::function<void()>& draw) const {
  if (samples() > 1) {
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, among);
  }
  glBeginQuery(GL_SAMPLES_PASSED, query_);
  draw();
  glEndQuery(GL_SAMPLES_PASSED);
  glDisable(GL_SAMPLE_MASK);
  GLuint passed = 0;
  glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &passed);
  return passed;
}

// Whether a pass that shades what an earlier one found finds the triangle there, whatever the stencil buffer holds.
bool StoryDrawer::depth_is_equal(const DrawPass& pass, const std::function<void()>& draw) {
  shop_.target->bind();
  set_pass(pass);
  glDisable(GL_STENCIL_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  return count_samples(all_samples(), draw) > 0;
}

// In the state of the picture's own pass. Each sample is drawn alone, so that the driver reports which are written.
StoryDrawer::Outcome StoryDrawer::draw_really(const DrawPass& pass, unsigned among, const std::function<void()>& draw) {
  Outcome outcome;
  const bool tests = plan_.settings.visibility == Visibility::depth_buffer && fills(plan_.settings.draw);
  const bool whole_picture = plan_.defers && pass.shades();
  bool equal = true;
  if (tests && !pass.finds_depth() && !whole_picture) equal = depth_is_equal(pass, draw);
  outcome.before = colour_now();
  outcome.stored = depth_now();
  outcome.sample = among & (~among + 1);
  if (samples() > 1) {
    outcome.samples = look_at_values(among, draw);
    if (!outcome.samples.stencil.empty())
      outcome.stencil = outcome.samples.stencil[static_cast<std::size_t>(std::countr_zero(among))];
  } else if (shop_.target->shape().stencil) {
    outcome.stencil = shop_.target->read_stencil(pixel_) & static_cast<int>(stencil_mask());
  }
  bind_picture(pass);
  set_pass(pass);
  for (int sample = 0; sample < samples(); ++sample)
    if (((among >> sample) & 1u) != 0 && count_samples(1u << sample, draw) > 0) outcome.written |= 1u << sample;
  if (samples() > 1 && !tests && pass.finds_depth()) outcome.written = among;  // see guard_neighbours()
  if (tests) {
    const bool passed = pass.finds_depth() ? outcome.written != 0 : equal;
    outcome.depth = passed ? FragmentEvent::Depth::passed : FragmentEvent::Depth::failed;
  }
  outcome.after = colour_now();
  if (pass.finds_depth() && outcome.written != 0) outcome.stored_after = depth_now();
  return outcome;
}

void StoryDrawer::report_pass(const DrawPass& pass) {
  if (plan_.counts_volumes && pass.kind == DrawPass::Kind::light) {
    const auto light = static_cast<std::size_t>(std::max(pass.light, 0));
    static const std::vector<VolumeBuffers> none;
    shop_.target->bind();
    count_volumes(pass.light >= 0 ? volumes_[light] : none);
  }
  if (pass.kind == DrawPass::Kind::geometry) {
    shop_.geometry->bind();
    shop_.geometry->clear();
  }
  if (plan_.defers && pass.shades()) return report_deferred(pass);
  for (NearTriangle& triangle : near_) {
    check_stop();
    report_triangle(triangle, pass);
  }
}

void StoryDrawer::report_triangle(NearTriangle& triangle, const DrawPass& pass) {
  const auto reject = [&](RejectReason reason) {
    if (!pass.finds_depth()) return;
    recorder_.event([&] {
      RejectEvent event;
      event.id = triangle.id;
      event.reason = reason;
      if (triangle.sphere_triangle >= 0) event.detail = "its triangle " + std::to_string(triangle.sphere_triangle);
      return event;
    });
  };
  if (triangle.covered == 0) return reject(RejectReason::not_covered);
  if (triangle.culled) return reject(RejectReason::back_face);
  const auto draw = [&] { draw_triangles(triangle.run); };
  Program& program = *programs_[triangle.run.surface];
  prepare_run(program, triangle.run, pass);
  bind_streams(triangle.run.object);
  const Outcome outcome = draw_really(pass, triangle.covered, draw);
  if (triangle.cut_out) return reject(RejectReason::cut_out);
  Program& story = story_program(triangle.run.surface);
  prepare_run(story, triangle.run, pass);
  const Asked asked{story, triangle.covered, draw};
  if (triangle.outside) {
    const Vec4f weights = page(asked, Page::weights);
    return reject(static_cast<double>(weights.w) < plan_.depth.near ? RejectReason::clipped_near
                                                                    : RejectReason::clipped_far);
  }
  if (pass.kind == DrawPass::Kind::geometry && outcome.written != 0)
    winner_ = static_cast<int>(&triangle - near_.data());
  const FragmentEvent fragment = fragment_event(triangle, asked, pass, outcome);
  recorder_.begin([&] { return fragment; });
  if (pass.kind == DrawPass::Kind::light && plan_.counts_volumes && outcome.depth == FragmentEvent::Depth::passed) {
    report_stencil(pass, outcome, fragment.z);
    prepare_run(story, triangle.run, pass);
    bind_streams(triangle.run.object);
  }
  if (pass.shades()) report_write(fragment, triangle, asked, pass, outcome);
  recorder_.end();
}

// One triangle over the whole picture shades what the pass before it kept of the pixel.
void StoryDrawer::report_deferred(const DrawPass& pass) {
  if (winner_ < 0) return;
  NearTriangle& triangle = near_[static_cast<std::size_t>(winner_)];
  Program& program = deferred_program();
  Outcome outcome = draw_really(pass, all_samples(), [&] { draw_whole_picture(program, pass); });
  outcome.depth = FragmentEvent::Depth::passed;
  const auto draw_again = [&] { draw_triangles(triangle.run); };
  Program& geometry_story = story_program(triangle.run.surface);
  prepare_run(geometry_story, triangle.run, pass);
  bind_streams(triangle.run.object);
  const Asked geometry{geometry_story, triangle.covered, draw_again};
  const FragmentEvent fragment = fragment_event(triangle, geometry, pass, outcome);
  recorder_.begin([&] { return fragment; });
  if (outcome.written != 0) report_surface(triangle, geometry);
  if (plan_.counts_volumes) report_stencil(pass, outcome, fragment.z);
  Program& story = deferred_story_program();
  const Asked shading{story, all_samples(), [&] { draw_whole_picture(story, pass); }};
  report_write(fragment, triangle, shading, pass, outcome);
  recorder_.end();
}

void StoryDrawer::report_canvas() {
  draw_canvas([&](const CanvasDraw& draw) {
    const Vec3d before = resolved_colour();
    shop_.target->bind_resolved();
    if (count_samples(1, [&] { draw_shape(draw); }) == 0) return;
    const Vec3d after = resolved_colour();
    shop_.story->bind_resolved();
    glDisable(GL_BLEND);
    glDrawArrays(draw.lines ? GL_LINES : GL_TRIANGLES, static_cast<GLint>(draw.first),
                 static_cast<GLsizei>(draw.count));
    const Vec4f shaded = shop_.story->read_pixel(pixel_);
    shop_.target->bind_resolved();
    glEnablei(GL_BLEND, 0);
    recorder_.event([&] { return WriteEvent{{}, before, vector_of(shaded), after}; });
    recorder_.count(Counter::pixels_written);
  });
}

}  // namespace ps::hardware
