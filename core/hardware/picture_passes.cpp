#include <epoxy/gl.h>

#include <algorithm>
#include <optional>

#include "base/stop.h"
#include "hardware/definitions.h"
#include "hardware/picture_drawer.h"

namespace ps::hardware {

void PictureDrawer::set_state() {
  const Settings& s = plan_.settings;
  shop_.target->bind();
  if (shop_.driver().clip_control) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  if (plan_.counts_volumes)
    glEnable(GL_DEPTH_CLAMP);  // see limits.glsl
  else
    glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_DITHER);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilMask(stencil_mask());
  shop_.target->clear(plan_.scene->background, plan_.depth.larger_is_nearer() ? 0.0f : 1.0f);
  if (plan_.region) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(plan_.region->x0, plan_.region->y0, plan_.region->width(), plan_.region->height());
  }
  const bool filled = fills(s.draw);
  glPolygonMode(GL_FRONT_AND_BACK, filled ? GL_FILL : s.draw == Draw::wireframe ? GL_LINE : GL_POINT);
  glCullFace(GL_BACK);
}

// Passes that shade what an earlier one found do so once for each pixel: of several fragments at the buffer's own depth
// the first counts on in the stencil, and the others no longer find its number there. Where the stencil counts shadow
// volumes it holds 0 for pixels in the light.
void PictureDrawer::set_pass(const DrawPass& pass) {
  const bool deferred = plan_.defers && pass.shades();
  const bool channels = pass.kind != DrawPass::Kind::depth && !deferred && !pass.adds;
  const GLboolean shades = pass.kind != DrawPass::Kind::depth;
  glColorMask(channels, channels, channels, channels);
  glColorMaski(0, shades, shades, shades, shades);
  glDepthMask(pass.finds_depth());
  glDepthFunc(!pass.finds_depth() ? GL_EQUAL : plan_.depth.larger_is_nearer() ? GL_GREATER : GL_LESS);
  if (plan_.settings.visibility == Visibility::depth_buffer && fills(plan_.settings.draw) && !deferred)
    glEnable(GL_DEPTH_TEST);
  else
    glDisable(GL_DEPTH_TEST);
  if (pass.finds_depth() || (deferred && !plan_.counts_volumes)) {
    glDisable(GL_STENCIL_TEST);
  } else {
    const int shaded = plan_.counts_volumes ? 0 : std::max(pass.light - first_light(plan_), 0) % 256;
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, shaded, stencil_mask());
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  }
  glDisable(GL_BLEND);
  if (!pass.adds) return;
  glEnablei(GL_BLEND, 0);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

unsigned PictureDrawer::stencil_mask() const {
  return plan_.counts_volumes ? (1u << plan_.settings.stencil_bits) - 1 : 0xffu;
}

void PictureDrawer::set_light(Program& program, const DrawPass& pass) {
  program.set("light_number", pass.light);
  program.set("first_light", first_light(plan_));
}

void PictureDrawer::set_facing(std::size_t object) {
  const raster::DrawObject& draw = plan_.objects[object];
  if (plan_.settings.backface_culling || draw.front_only)
    glEnable(GL_CULL_FACE);
  else
    glDisable(GL_CULL_FACE);
  const double sense = plan_.camera_space.handedness * (draw.mirrored ? -1 : 1);
  glFrontFace(sense > 0 ? GL_CCW : GL_CW);
}

void PictureDrawer::prepare_run(Program& program, const DrawRun& run, const DrawPass& pass) {
  program.use();
  set_view(program);
  set_depth(program);
  set_object(program, run.object);
  set_facing(run.object);
  set_surface(program, plan_.surfaces.list[run.surface]);
  program.set("surface_number", static_cast<int>(run.surface));
  set_light(program, pass);
}

void PictureDrawer::draw_triangles(const DrawRun& run) const {
  const auto corners = static_cast<GLsizei>(3 * run.count);
  const std::size_t first = 3 * run.first;
  if (sorted_ != 0)
    // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes the offset as a pointer
    glDrawElements(GL_TRIANGLES, corners, GL_UNSIGNED_INT, reinterpret_cast<const void*>(first * sizeof(GLuint)));
  else
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), corners);
}

void PictureDrawer::draw_runs(const DrawPass& pass) {
  std::optional<std::size_t> bound;
  for (const DrawRun& run : runs_) {
    check_stop();
    prepare_run(*programs_[run.surface], run, pass);
    if (bound != run.object) bind_streams(run.object);
    bound = run.object;
    draw_triangles(run);
  }
}

Program& PictureDrawer::deferred_program() {
  return program_of("whole_picture.glsl", "deferred.glsl", deferred_definitions(plan_, shop_.driver().clip_control));
}

// Deferred shading of all pixels that show a surface.
void PictureDrawer::draw_whole_picture(Program& program, const DrawPass& pass) {
  program.use();
  set_view(program);
  set_light(program, pass);
  set_geometry(program);
  glDisable(GL_CULL_FACE);
  for (GLuint place = 0; place < stream_count; ++place) glDisableVertexAttribArray(place);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Program& PictureDrawer::volume_program() {
  return program_of("volume_vertex.glsl", "volume_fragment.glsl",
                    volume_definitions(plan_, shop_.driver().clip_control));
}

// Faces beyond a far limit are left out unless the options ask for all of them.
void PictureDrawer::set_volume_state(Program& program) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(plan_.depth.larger_is_nearer() ? GL_GREATER : GL_LESS);
  glDisable(GL_CULL_FACE);
  glFrontFace(plan_.camera_space.handedness > 0 ? GL_CCW : GL_CW);
  program.use();
  set_view(program);
  set_depth(program);
  if (plan_.settings.volume_depth_clamp) program.set("far_limit", 0.0f);
}

// Counts the faces of a light's shadow volumes: depth-fail those behind the surface, depth-pass those before it (CGFS
// ch. 15).
void PictureDrawer::count_volumes(const std::vector<VolumeBuffers>& volumes) {
  const Settings& s = plan_.settings;
  const GLint zero = 0;
  glClearBufferiv(GL_STENCIL, 0, &zero);
  Program& program = volume_program();
  set_volume_state(program);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 0, stencil_mask());
  const bool fail = s.shadows == Shadows::stencil_depth_fail;
  const auto count = [&](GLenum face, GLenum change) {
    glStencilOpSeparate(face, GL_KEEP, fail ? change : GL_KEEP, fail ? GL_KEEP : change);
  };
  for (const VolumeBuffers& volume : volumes) {
    check_stop();
    set_object(program, volume.object());
    volume.bind();
    const GLenum enter = fail ? GL_DECR_WRAP : GL_INCR_WRAP, leave = fail ? GL_INCR_WRAP : GL_DECR_WRAP;
    count(GL_FRONT, enter);
    count(GL_BACK, leave);
    glDrawArrays(GL_TRIANGLES, 0, volume.outwards());
    count(GL_FRONT, leave);
    count(GL_BACK, enter);
    glDrawArrays(GL_TRIANGLES, volume.outwards(), volume.inwards());
  }
}

void PictureDrawer::draw_pass(const DrawPass& pass) {
  if (plan_.counts_volumes && pass.kind == DrawPass::Kind::light) {
    const auto light = static_cast<std::size_t>(std::max(pass.light, 0));
    static const std::vector<VolumeBuffers> none;
    count_volumes(pass.light >= 0 ? volumes_[light] : none);
  }
  const bool geometry = pass.kind == DrawPass::Kind::geometry;
  if (geometry)
    shop_.geometry->bind();
  else
    shop_.target->bind();
  if (geometry) shop_.geometry->clear();
  set_pass(pass);
  if (pass.counted) glBeginQuery(GL_SAMPLES_PASSED, query_);
  if (plan_.defers && pass.shades())
    draw_whole_picture(deferred_program(), pass);
  else
    draw_runs(pass);
  if (!pass.counted) return;
  glEndQuery(GL_SAMPLES_PASSED);
  GLuint passed = 0;
  glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &passed);
  samples_written_ += passed;
}

void PictureDrawer::resolve_channels() {
  const FramebufferShape& shape = shop_.target->shape();
  if (shape.samples == 1 || !shape.channels) return;
  if (!shop_.channel_resolver) shop_.channel_resolver = std::make_unique<ChannelResolver>();
  for (GLuint place = 0; place < stream_count; ++place) glDisableVertexAttribArray(place);
  shop_.channel_resolver->resolve(*shop_.target);
}

void PictureDrawer::draw() {
  glFinish();
  set_state();
  for (const DrawPass& pass : draw_passes(plan_)) draw_pass(pass);
  shop_.target->resolve();
  resolve_channels();
  draw_canvas(draw_shape);
  glFinish();
  check_gl("drawing");
}

}  // namespace ps::hardware
