#include "hardware/picture_drawer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "base/check.h"
#include "base/stop.h"
#include "hardware/definitions.h"
#include "raster/setup/textures.h"

namespace ps::hardware {
namespace {

constexpr unsigned lights_binding = 0, maps_binding = 1;
constexpr int maps_unit = 7;
constexpr std::size_t light_bytes = 3 * sizeof(Vec4f);

/// The matrix of cofactors is the inverse transpose times the determinant: triangles' own normals.
Mat3d surface_matrix(const raster::DrawObject& object) {
  const Mat3d& m = object.linear;
  return Mat3d(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])) * (object.mirrored ? -1.0 : 1.0);
}

/// The factor that keeps a depth within 0..1: a power of two, which changes no comparison.
float depth_factor(const PicturePlan& plan) {
  if (plan.depth.value == DepthValue::inverse_z)
    return static_cast<float>(std::exp2(std::floor(std::log2(plan.depth.near))));
  const Vec2d reach(plan.viewport.columns / plan.projection.scale.x, plan.viewport.rows / plan.projection.scale.y);
  const double longest = plan.perspective() ? plan.farthest * std::sqrt(1 + dot(reach, reach)) : plan.farthest;
  return static_cast<float>(std::exp2(-std::floor(std::log2(longest)) - 1));
}

/// Where a vertex lies before the camera. Without camera-relative positions its place in the world and the camera's are
/// rounded to float first, as vertex.glsl has them.
Vec3d camera_position(const PicturePlan& plan, const Vec3d& world) {
  if (plan.settings.camera_relative) return plan.camera_space.point(world);
  return plan.camera_space.from_world * Vec3d(Vec3f(world) - Vec3f(plan.camera_space.position));
}

/// The middle of the canvas where samples lie at the centres of pixels, as a driver has them: pixels.
Vec2d shifted_centre(const PicturePlan& plan) { return plan.projection.centre + Vec2d(0.5) - plan.viewport.sample; }

}  // namespace

PictureDrawer::PictureDrawer(const PicturePlan& plan, Workshop& shop)
    : plan_(plan), shop_(shop), keeps_depth_(driver_keeps_depth(plan, shop.driver().clip_control)),
      snapped_(plan.objects.size(), 0) {}

PictureDrawer::~PictureDrawer() {
  glDeleteBuffers(static_cast<GLsizei>(snapped_.size()), snapped_.data());
  glDeleteBuffers(1, &sorted_);
  glDeleteQueries(1, &query_);
}

TargetShape PictureDrawer::target_shape() const {
  TargetShape shape;
  shape.width = plan_.viewport.columns;
  shape.height = plan_.viewport.rows;
  shape.stencil = draws_in_passes(plan_);
  shape.channels = plan_.channels != Channel::none;
  shape.samples = sample_count(plan_.settings);
  if (keeps_depth_ && plan_.depth.format == DepthFormat::unorm)
    shape.depth = plan_.depth.bits == 16 ? DepthStore::unorm16 : DepthStore::unorm24;
  return shape;
}

void PictureDrawer::upload() {
  if (!shop_.target || shop_.target->shape() != target_shape()) {
    shop_.target.reset();
    shop_.target = std::make_unique<Target>(target_shape());
  }
  if (shop_.vertex_array == 0) glGenVertexArrays(1, &shop_.vertex_array);
  glBindVertexArray(shop_.vertex_array);
  upload_lights();
  for (std::size_t i = 0; i < plan_.objects.size(); ++i) upload_object(i);
  for (const raster::Surface<float>& surface : plan_.surfaces.list) {
    check_stop();
    programs_.push_back(&program_of(surface));
    programs_.back()->use();
    set_surface(*programs_.back(), surface);  // uploads its textures
  }
  if (plan_.settings.visibility == Visibility::painter)
    make_sorted_runs();
  else
    make_runs();
  glGenQueries(1, &query_);
  check_gl("uploading the scene");
}

void PictureDrawer::upload_lights() {
  const std::size_t most = static_cast<std::size_t>(shop_.driver().max_block_bytes) / light_bytes;
  if (plan_.lights.size() > most)
    throw InputError(fmt::format("{} lights: this graphics driver holds at most {} of them in a uniform block",
                                 plan_.lights.size(), most));
  std::vector<Vec4f> values;
  for (const ShadingLight<float>& light : plan_.lights) {
    values.emplace_back(light.colour, light.intensity);
    values.emplace_back(light.vector, static_cast<float>(light.kind));
    values.emplace_back(light.attenuation, light.attenuates ? 1.0f : 0.0f);
  }
  if (shop_.lights == 0) glGenBuffers(1, &shop_.lights);
  glBindBuffer(GL_UNIFORM_BUFFER, shop_.lights);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(std::max<std::size_t>(values.size(), 3) * sizeof(Vec4f)),
               nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(values.size() * sizeof(Vec4f)), values.data());
  glBindBufferBase(GL_UNIFORM_BUFFER, lights_binding, shop_.lights);
}

void PictureDrawer::upload_object(std::size_t object) {
  check_stop();
  const std::shared_ptr<const Mesh>& mesh = plan_.objects[object].mesh;
  if (mesh->triangles.empty()) return;
  MeshBuffers& buffers = shop_.meshes.get(mesh);
  for (const Stream stream : streams_of(object)) buffers.need(stream, *mesh);
  if (plan_.settings.vertex_snapping == VertexSnapping::cpu) snap_vertices(object);
}

// Projects in double and rounds to the sub-pixels of the driver, whose own projection then moves no vertex to another.
void PictureDrawer::snap_vertices(std::size_t object) {
  const raster::DrawObject& draw = plan_.objects[object];
  const double steps = std::exp2(shop_.driver().subpixel_bits);
  constexpr double reach = 32768;  // pixels; beyond, the driver clips
  const Vec2d centre = shifted_centre(plan_);
  std::vector<Vec3f> places(draw.mesh->positions.size(), Vec3f(0));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3d camera = camera_position(plan_, draw.world(draw.mesh->positions[i]));
    if (plan_.perspective() && !(camera.z > 0)) continue;
    const Vec2d at = plan_.projection.centred(camera);
    const Vec2d canvas(std::nearbyint((centre.x + at.x) * steps) / steps,
                       std::nearbyint((centre.y - at.y) * steps) / steps);
    if (std::abs(canvas.x) < reach && std::abs(canvas.y) < reach) places[i] = Vec3f(Vec2f(canvas), 1);
  }
  std::vector<Vec3f> corners;
  corners.reserve(3 * draw.mesh->triangles.size());
  for (const MeshTriangle& triangle : draw.mesh->triangles)
    for (const std::uint32_t p : triangle.position) corners.push_back(places[p]);
  glGenBuffers(1, &snapped_[object]);
  glBindBuffer(GL_ARRAY_BUFFER, snapped_[object]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Vec3f)), corners.data(),
               GL_STREAM_DRAW);
}

Program& PictureDrawer::program_of(const raster::Surface<float>& surface) {
  const std::string key = definitions(plan_, surface, shop_.driver().clip_control);
  std::unique_ptr<Program>& program = shop_.programs[key];
  if (!program) {
    program = std::make_unique<Program>("vertex.glsl", "fragment.glsl", shop_.context.api(), key);
    program->bind_block("Lights", lights_binding);
    program->bind_block("ShadowMaps", maps_binding);
  }
  return *program;
}

void PictureDrawer::make_runs() {
  for (std::size_t i = 0; i < plan_.objects.size(); ++i) {
    const raster::DrawObject& draw = plan_.objects[i];
    if (draw.mesh->triangles.empty()) continue;
    const bool one_material = draw.materials.size() == 1;
    for (const SlotRun& run : shop_.meshes.get(draw.mesh).runs()) {
      const std::size_t surface = plan_.surfaces.first[i] + (one_material ? 0 : run.slot);
      if (one_material && !runs_.empty() && runs_.back().object == i)
        runs_.back().count += run.count;
      else
        runs_.push_back({i, surface, run.first, run.count});
    }
    triangles_ += draw.mesh->triangles.size();
  }
}

// The painter's algorithm: by the mean depth of the corners, as the rasterizer sorts them.
void PictureDrawer::make_sorted_runs() {
  struct Sorted {
    float depth = 0;
    std::uint32_t object = 0, triangle = 0;
  };
  std::vector<Sorted> order;
  for (std::size_t i = 0; i < plan_.objects.size(); ++i) {
    const raster::DrawObject& draw = plan_.objects[i];
    std::vector<float> depth;
    depth.reserve(draw.mesh->positions.size());
    for (const Vec3d& p : draw.mesh->positions)
      depth.push_back(static_cast<float>(camera_position(plan_, draw.world(p)).z));
    for (std::size_t t = 0; t < draw.mesh->triangles.size(); ++t) {
      const auto& p = draw.mesh->triangles[t].position;
      order.push_back({(depth[p[0]] + depth[p[1]] + depth[p[2]]) / 3.0f, static_cast<std::uint32_t>(i),
                       static_cast<std::uint32_t>(t)});
    }
  }
  // At equal depth the first triangle is drawn last.
  std::reverse(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(), [](const Sorted& a, const Sorted& b) { return a.depth > b.depth; });
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const raster::DrawObject& draw = plan_.objects[order[i].object];
    const std::uint32_t slot = draw.materials.size() == 1 ? 0 : draw.mesh->triangles[order[i].triangle].material;
    const std::size_t surface = plan_.surfaces.first[order[i].object] + slot;
    if (runs_.empty() || runs_.back().object != order[i].object || runs_.back().surface != surface)
      runs_.push_back({order[i].object, surface, i, 0});
    ++runs_.back().count;
    for (std::uint32_t k = 0; k < 3; ++k) corners.push_back(3 * order[i].triangle + k);
  }
  triangles_ = order.size();
  glGenBuffers(1, &sorted_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, sorted_);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(std::uint32_t)), corners.data(),
               GL_STREAM_DRAW);
}

/// What the shaders read of a mesh, without snapped positions.
std::vector<Stream> PictureDrawer::streams_of(std::size_t object) const {
  const Settings& s = plan_.settings;
  const Mesh& mesh = *plan_.objects[object].mesh;
  std::vector<Stream> streams{Stream::positions, Stream::triangle_normals};
  const bool vertex_normals = s.normals == Normals::vertex;
  if (vertex_normals) streams.push_back(Stream::normals);
  if (!mesh.uvs.empty()) streams.insert(streams.end(), {Stream::uvs, Stream::along_u, Stream::upwards});
  if (!s.lighting || s.shading != Shading::flat) return streams;
  streams.push_back(Stream::centres);
  if (vertex_normals) streams.insert(streams.end(), {Stream::normals_0, Stream::normals_1, Stream::normals_2});
  return streams;
}

void PictureDrawer::bind_streams(std::size_t object) {
  const MeshBuffers& buffers = shop_.meshes.get(plan_.objects[object].mesh);
  for (GLuint place = 0; place < stream_count; ++place) glDisableVertexAttribArray(place);
  for (const Stream stream : streams_of(object)) buffers.bind(stream);
  if (snapped_[object] == 0) return;
  glBindBuffer(GL_ARRAY_BUFFER, snapped_[object]);
  glEnableVertexAttribArray(static_cast<GLuint>(Stream::snapped));
  glVertexAttribPointer(static_cast<GLuint>(Stream::snapped), 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void PictureDrawer::set_state() {
  const Settings& s = plan_.settings;
  shop_.target->bind();
  if (shop_.driver().clip_control) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glDisable(GL_DITHER);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glStencilMask(0xff);
  shop_.target->clear(plan_.scene->background, plan_.depth.larger_is_nearer() ? 0.0f : 1.0f);
  if (plan_.region) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(plan_.region->x0, plan_.region->y0, plan_.region->width(), plan_.region->height());
  }
  const bool filled = s.draw == Draw::filled;
  glPolygonMode(GL_FRONT_AND_BACK, filled ? GL_FILL : s.draw == Draw::wireframe ? GL_LINE : GL_POINT);
  glCullFace(GL_BACK);
  if (s.visibility == Visibility::depth_buffer && filled)
    glEnable(GL_DEPTH_TEST);
  else
    glDisable(GL_DEPTH_TEST);
}

// Passes that shade what an earlier one found do so once for each pixel: of several fragments at the buffer's own depth
// the first counts on in the stencil, and the others no longer find its number there.
void PictureDrawer::set_step(const raster::DrawStep& step) {
  const bool first = step.is_first();
  const GLboolean shades = step.stage != raster::DrawStage::depth_only;
  glColorMask(shades, shades, shades, shades);
  glDepthMask(first);
  glDepthFunc(!first ? GL_EQUAL : plan_.depth.larger_is_nearer() ? GL_GREATER : GL_LESS);
  const int light = step.stage == raster::DrawStage::one_light ? step.light : 0;
  if (first) {
    glDisable(GL_STENCIL_TEST);
  } else {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, light % 256, 0xff);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR_WRAP);
  }
  if (light > 0) {
    glEnablei(GL_BLEND, 0);  // lights after the first add to the picture
    glBlendFunc(GL_ONE, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
}

void PictureDrawer::set_object(Program& program, std::size_t object) {
  const raster::DrawObject& draw = plan_.objects[object];
  const Vec3d centre = draw.world(shop_.meshes.get(draw.mesh).centre());
  program.set("to_world", draw.linear);
  program.set("world_shift", Vec3f(centre));
  const Mat3d& from_world = plan_.camera_space.from_world;
  program.set("to_camera", plan_.settings.camera_relative ? from_world * draw.linear : from_world);
  program.set("camera_shift", Vec3f(plan_.camera_space.point(centre)));
  program.set("normal_matrix", draw.normal_matrix);
  program.set("surface_matrix", surface_matrix(draw));
  program.set("object_number", draw.object);
  program.set("numbered", draw.sphere ? 0 : 1);
  if (plan_.settings.backface_culling || draw.front_only)
    glEnable(GL_CULL_FACE);
  else
    glDisable(GL_CULL_FACE);
  const double sense = plan_.camera_space.handedness * (draw.mirrored ? -1 : 1);
  glFrontFace(sense > 0 ? GL_CCW : GL_CW);
}

void PictureDrawer::set_view(Program& program) {
  const Vec2d size(plan_.viewport.columns, plan_.viewport.rows), scale = plan_.projection.scale;
  const Vec2d centre = shifted_centre(plan_);
  program.set("canvas_scale", Vec2f(Vec2d(2 * scale.x / size.x, -2 * scale.y / size.y)));
  program.set("canvas_shift", Vec2f(Vec2d(2 * centre.x / size.x - 1, 2 * centre.y / size.y - 1)));
  program.set("canvas_size", Vec2f(size));
  program.set("eye", Vec3f(plan_.camera.position));
  program.set("backward", Vec3f(-plan_.camera.forward));
  program.set("camera_right", Vec3f(plan_.camera.right));
  program.set("camera_up", Vec3f(plan_.camera.up));
  program.set("camera_forward", Vec3f(plan_.camera.forward));
  program.set("view_scale", Vec2f(Vec2d(scale.x, -scale.y)));
  program.set("view_centre", Vec2f(centre));
  program.set("plane_scale", Vec2f(Vec2d(scale.x, -scale.y)));
  program.set("plane_centre", Vec2f(centre));
  program.set("mip_bias", static_cast<float>(plan_.settings.mip_bias));
}

void PictureDrawer::set_depth(Program& program) {
  const raster::DepthCode& depth = plan_.depth;
  program.set("near_z", static_cast<float>(depth.near));
  program.set("far_share", static_cast<float>(depth.far > 0 ? depth.near / depth.far : 0));
  program.set("far_z", static_cast<float>(plan_.farthest));
  program.set("depth_near", static_cast<float>(depth.near));
  program.set("depth_far", static_cast<float>(depth.far));
  program.set("depth_factor", depth_factor(plan_));
  program.set("depth_steps", static_cast<float>(std::exp2(depth.bits)));
}

void PictureDrawer::set_surface(Program& program, const raster::Surface<float>& surface) {
  const ShadingMaterial<float>& material = surface.material;
  const Vec3f none(0);
  program.set("surface_colour", material.colour);
  program.set("exponent", material.specular.value_or(1.0f));
  program.set("specular_colour", Vec4f(material.specular_colour.value_or(none), material.specular_colour ? 1 : 0));
  program.set("ambient_colour", Vec4f(material.ambient_colour.value_or(none), material.ambient_colour ? 1 : 0));
  program.set("relief_depth", material.relief_depth);
  if (plan_.shadow_maps) set_shadows(program, surface);
  if (!plan_.textures) return;
  int unit = 0;
  for (const auto& [name, texture] : {std::pair{"surface", material.texture},
                                      {"opacity", material.opacity_map},
                                      {"specular", material.specular_map},
                                      {"ambient", material.ambient_map},
                                      {"normal", material.normal_map},
                                      {"height", material.height_map}}) {
    if (texture < 0) continue;
    const MipChain& chain = (*plan_.textures)[static_cast<std::size_t>(texture)];
    const Vec4<int> layout = shop_.textures.bind(chain, unit, plan_.settings, shop_.driver().max_size);
    program.set(fmt::format("{}_layout", name), layout);
    program.set(fmt::format("{}_picture", name), unit);
    program.set(fmt::format("{}_wrap", name), static_cast<int>(raster::wrap_of(chain, plan_.settings)));
    ++unit;
  }
}

void PictureDrawer::set_shadows(Program& program, const raster::Surface<float>& surface) {
  const Settings& s = plan_.settings;
  const Vec2d& scale = plan_.projection.scale;
  shop_.maps.bind(plan_.shadow_maps, maps_unit, maps_binding);
  program.set("shadow_depths", maps_unit);
  program.set("shadow_map_size", s.shadow_map_size);
  program.set("shadow_bias", static_cast<float>(s.shadow_bias));
  program.set("shadow_slope_bias", static_cast<float>(s.shadow_slope_bias));
  const double error = surface.sphere ? s.tessellation / std::min(scale.x, scale.y) : 0;
  program.set("surface_error_scale", static_cast<float>(error));
}

void PictureDrawer::draw_runs(const raster::DrawStep& step) {
  std::optional<std::size_t> bound;
  for (const DrawRun& run : runs_) {
    check_stop();
    Program& program = *programs_[run.surface];
    program.use();
    set_view(program);
    set_depth(program);
    set_object(program, run.object);
    set_surface(program, plan_.surfaces.list[run.surface]);
    program.set("light_number", step.light);
    if (bound != run.object) bind_streams(run.object);
    bound = run.object;
    const auto corners = static_cast<GLsizei>(3 * run.count);
    const std::size_t first = 3 * run.first;
    if (sorted_ != 0)
      // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes the offset as a pointer
      glDrawElements(GL_TRIANGLES, corners, GL_UNSIGNED_INT, reinterpret_cast<const void*>(first * sizeof(GLuint)));
    else
      glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), corners);
  }
}

void PictureDrawer::draw() {
  glFinish();
  set_state();
  for (const raster::DrawStep& step : raster::draw_steps(plan_.settings, plan_.lights.size())) {
    set_step(step);
    const bool shades = step.stage != raster::DrawStage::depth_only;
    if (shades) glBeginQuery(GL_SAMPLES_PASSED, query_);
    draw_runs(step);
    if (!shades) continue;
    glEndQuery(GL_SAMPLES_PASSED);
    GLuint passed = 0;
    glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &passed);
    samples_written_ += passed;
  }
  shop_.target->resolve();
  glFinish();
  check_gl("drawing");
}

}  // namespace ps::hardware
