#include "hardware/story_drawer.h"

#include <epoxy/gl.h>

#include <array>

#include "base/stop.h"
#include "frame/display_frame.h"
#include "hardware/context.h"
#include "hardware/near_triangles.h"
#include "image/display.h"

namespace ps::hardware {

StoryDrawer::StoryDrawer(const PicturePlan& plan, Workshop& shop, Vec2i pixel)
    : PictureDrawer(plan, shop), pixel_(pixel), recorder_(pixel) {
  // A picture and its story have targets of their own, so that neither is made anew for the other.
  std::swap(shop_.target, shop_.story_picture);
  std::swap(shop_.geometry, shop_.story_geometry);
}

StoryDrawer::~StoryDrawer() {
  glDisable(GL_SAMPLE_MASK);
  std::swap(shop_.target, shop_.story_picture);
  std::swap(shop_.geometry, shop_.story_geometry);
}

void StoryDrawer::report(PixelStory& story) {
  upload();
  FramebufferShape shape = framebuffer_shape();
  shape.channels = false;
  if (samples() == 1) {
    shape.depth = DepthStore::float32;  // not asked for
    shape.stencil = false;
  }
  if (!shop_.story || shop_.story->shape() != shape) {
    shop_.story.reset();
    shop_.story = std::make_unique<Framebuffer>(shape);
  }
  set_state();
  if (samples() > 1) guard_neighbours();
  find_near(story);
  find_covering();
  for (const DrawPass& pass : draw_passes(plan_)) report_pass(pass);
  glDisable(GL_SAMPLE_MASK);
  shop_.target->resolve();
  report_canvas();
  story.linear = resolved_colour();
  const Rgb8 levels = display_pixel(story.linear, display_transform(plan_.settings));
  story.display = {levels.r, levels.g, levels.b};
  recorder_.event([&] { return PixelEvent{story.linear, story.display}; });
  recorder_.count(Counter::triangles_in, triangles());
  story.counters = recorder_.counters;
  if (samples() > 1) story.counters.given = {Counter::triangles_in, Counter::nan_pixels};
  story.events = recorder_.take();
  check_gl("asking for the story of a pixel");
}

void StoryDrawer::find_near(PixelStory& story) {
  const NearTest test(plan_, *plan_.region);
  std::vector<std::vector<bool>> near(plan_.objects.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    check_stop();
    near[i] = test.of_object(i);
  }
  for (const DrawRun& run : runs_) {
    const raster::DrawObject& object = plan_.objects[run.object];
    for (std::size_t i = run.first; i < run.first + run.count; ++i) {
      const std::size_t triangle = sorted_triangles_.empty() ? i : sorted_triangles_[i];
      if (!near[run.object][triangle]) continue;
      NearTriangle& found = near_.emplace_back();
      found.run = {run.object, run.surface, i, 1};
      found.id = {object.object, object.sphere ? 0 : static_cast<int>(triangle)};
      if (object.sphere) found.sphere_triangle = static_cast<int>(triangle);
    }
  }
  story.triangles_elsewhere = triangles() - near_.size();
}

// Mesa's llvmpipe draws multisampled triangles half a pixel over the left and upper border of the scissor rectangle:
// samples of other pixels are counted, too. So around the pixel everything fails the tests for depth and stencil.
void StoryDrawer::guard_neighbours() const {
  const float nearest = plan_.depth.larger_is_nearer() ? 1.0f : 0.0f;
  const GLint full = 255;
  const bool stencil = shop_.target->shape().stencil;
  if (stencil) glStencilMask(0xff);
  for (const auto& [x, y, width, height] :
       std::array<std::array<int, 4>, 4>{{{-1, -1, 3, 1}, {-1, 1, 3, 1}, {-1, 0, 1, 1}, {1, 0, 1, 1}}}) {
    glScissor(pixel_.x + x, pixel_.y + y, width, height);
    glClearBufferfv(GL_DEPTH, 0, &nearest);
    if (stencil) glClearBufferiv(GL_STENCIL, 0, &full);
  }
  glStencilMask(stencil_mask());
  glScissor(pixel_.x, pixel_.y, 1, 1);
}

// Leaves those samples of the triangle that it covers really, and gives what it writes there.
Vec4f StoryDrawer::look_at_samples(Program& program, NearTriangle& triangle) const {
  const auto draw = [&] { draw_triangles(triangle.run); };
  if (samples() == 1) return page({program, 1, draw}, Page::seen);
  Vec4f seen(0);
  for (unsigned sample = 1; sample <= triangle.covered; sample <<= 1) {
    if ((triangle.covered & sample) == 0) continue;
    const Vec4f here = page({program, sample, draw}, Page::seen);
    if (here.x > 0)
      seen = here;
    else
      triangle.covered &= ~sample;
  }
  return seen;
}

// Without depth and stencil tests and with both sides, which the picture's own programs and passes then decide about.
void StoryDrawer::find_covering() {
  const DrawPass pass = draw_passes(plan_).front();
  std::vector<GLuint> queries(near_.size() * static_cast<std::size_t>(samples()));
  glGenQueries(static_cast<GLsizei>(queries.size()), queries.data());
  begin_asking();
  std::size_t next = 0;
  std::optional<std::size_t> bound;
  for (const NearTriangle& triangle : near_) {
    check_stop();
    Program& program = story_program(triangle.run.surface);
    prepare_run(program, triangle.run, pass);
    glDisable(GL_CULL_FACE);
    if (bound != triangle.run.object) bind_streams(triangle.run.object);
    bound = triangle.run.object;
    for (int sample = 0; sample < samples(); ++sample) {
      glSampleMaski(0, 1u << sample);
      glBeginQuery(GL_SAMPLES_PASSED, queries[next++]);
      draw_triangles(triangle.run);
      glEndQuery(GL_SAMPLES_PASSED);
    }
  }
  next = 0;
  for (NearTriangle& triangle : near_)
    for (int sample = 0; sample < samples(); ++sample) {
      GLuint passed = 0;
      glGetQueryObjectuiv(queries[next++], GL_QUERY_RESULT, &passed);
      if (passed > 0) triangle.covered |= 1u << sample;
    }
  glDeleteQueries(static_cast<GLsizei>(queries.size()), queries.data());
  for (NearTriangle& triangle : near_) {
    if (triangle.covered == 0) continue;
    Program& program = story_program(triangle.run.surface);
    prepare_run(program, triangle.run, pass);
    bind_streams(triangle.run.object);
    const Vec4f seen = look_at_samples(program, triangle);
    if (triangle.covered == 0) continue;
    const raster::DrawObject& object = plan_.objects[triangle.run.object];
    const auto flags = static_cast<unsigned>(seen.w);
    triangle.front = seen.z > 0;
    triangle.culled = !triangle.front && (plan_.settings.backface_culling || object.front_only);
    triangle.cut_out = (flags & 1u) != 0;
    triangle.outside = (flags & 2u) != 0;
  }
}

}  // namespace ps::hardware
