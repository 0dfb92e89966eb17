#include "hardware/picture_drawer.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/available_memory.h"
#include "base/check.h"
#include "base/stop.h"
#include "hardware/definitions.h"
#include "hardware/draw_passes.h"
#include "hardware/picture_units.h"

namespace ps::hardware {

PictureDrawer::PictureDrawer(const PicturePlan& plan, Workshop& shop)
    : plan_(plan), shop_(shop), keeps_depth_(driver_keeps_depth(plan, shop.driver().clip_control)),
      places_(plan.objects.size()), snapped_(plan.objects.size(), 0) {}

PictureDrawer::~PictureDrawer() {
  glDeleteBuffers(static_cast<GLsizei>(snapped_.size()), snapped_.data());
  glDeleteBuffers(1, &sorted_);
  glDeleteTextures(1, &surface_table_);
  glDeleteQueries(1, &query_);
}

FramebufferShape PictureDrawer::framebuffer_shape() const {
  FramebufferShape shape;
  shape.width = plan_.viewport.columns;
  shape.height = plan_.viewport.rows;
  shape.stencil = draw_passes(plan_).size() > 1;
  shape.channels = plan_.channels != Channel::none;
  shape.samples = sample_count(plan_.settings);
  if (keeps_depth_ && plan_.depth.format == DepthFormat::unorm)
    shape.depth = plan_.depth.bits == 16 ? DepthStore::unorm16 : DepthStore::unorm24;
  return shape;
}

void PictureDrawer::upload() {
  if (!shop_.target || shop_.target->shape() != framebuffer_shape()) {
    shop_.geometry.reset();  // shares the target's depth buffer
    shop_.target.reset();
    shop_.target = std::make_unique<Framebuffer>(framebuffer_shape());
  }
  if (plan_.defers && !shop_.geometry) shop_.geometry = std::make_unique<GeometryBuffer>(*shop_.target);
  if (shop_.vertex_array == 0) glGenVertexArrays(1, &shop_.vertex_array);
  glBindVertexArray(shop_.vertex_array);
  upload_lights();
  require_room_for_meshes();
  for (std::size_t i = 0; i < plan_.objects.size(); ++i) upload_object(i);
  for (const raster::Surface<float>& surface : plan_.surfaces.list) {
    check_stop();
    programs_.push_back(&program_of(surface));
    programs_.back()->use();
    set_surface(*programs_.back(), surface);  // uploads its textures
  }
  if (plan_.defers) upload_surface_table();
  if (plan_.counts_volumes) upload_volumes();
  if (plan_.settings.visibility == Visibility::painter)
    make_sorted_runs();
  else
    make_runs();
  glGenQueries(1, &query_);
  glFinish();  // what is uploaded belongs to the time of the upload, and not to that of drawing
  check_gl("uploading the scene");
}

void PictureDrawer::require_room_for_meshes() {
  std::uint64_t bytes = 0;
  std::set<const Mesh*> counted;  // objects may share one
  for (std::size_t i = 0; i < plan_.objects.size(); ++i) {
    const std::shared_ptr<const Mesh>& mesh = plan_.objects[i].mesh;
    if (!counted.insert(mesh.get()).second) continue;
    for (const Stream stream : streams_of(i)) bytes += shop_.meshes.get(mesh).missing_bytes(stream, *mesh);
  }
  require_memory(bytes, available_memory(), "the vertices in the memory of the graphics driver",
                 "set a larger 'tessellation', or draw a smaller picture or fewer triangles");
}

void PictureDrawer::upload_lights() {
  const std::size_t rows = plan_.term_colours ? 5 : 3;  // of a light, as lighting.glsl has them
  const std::size_t most = static_cast<std::size_t>(shop_.driver().max_block_bytes) / (rows * sizeof(Vec4f));
  if (plan_.lights.size() > most)
    throw InputError(fmt::format("{} lights: this graphics driver holds at most {} of them in a uniform block",
                                 plan_.lights.size(), most));
  std::vector<Vec4f> values;
  for (const ShadingLight<float>& light : plan_.lights) {
    values.emplace_back(light.colour, light.intensity);
    values.emplace_back(light.vector, static_cast<float>(light.kind));
    values.emplace_back(light.attenuation, light.attenuates ? 1.0f : 0.0f);
    if (!plan_.term_colours) continue;
    values.emplace_back(light.specular_colour, 0.0f);
    values.emplace_back(light.ambient_colour, 0.0f);
  }
  if (shop_.lights == 0) glGenBuffers(1, &shop_.lights);
  glBindBuffer(GL_UNIFORM_BUFFER, shop_.lights);
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(std::max(values.size(), rows) * sizeof(Vec4f)), nullptr,
               GL_STREAM_DRAW);
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
  std::vector<Vec3f>& places = places_[object];
  places.assign(draw.mesh->positions.size(), Vec3f(0));
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

// The painter's algorithm: by the mean depth of the vertices, as the rasterizer sorts them.
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
    sorted_triangles_.push_back(order[i].triangle);
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

// As deferred.glsl reads it.
void PictureDrawer::upload_surface_table() {
  constexpr std::size_t columns = 2 * surface_table_columns;
  const std::size_t rows = std::max<std::size_t>((2 * plan_.surfaces.list.size() + columns - 1) / columns, 1);
  std::vector<Vec4f> texels(rows * columns, Vec4f(0));
  if (plan_.environment) shop_.environment.bind(plan_.environment, environment_unit);
  for (std::size_t i = 0; i < plan_.surfaces.list.size(); ++i) {
    const raster::Surface<float>& surface = plan_.surfaces.list[i];
    const ShadingMaterial<float>& material = surface.material;
    texels[2 * i] = {material.specular.value_or(-1.0f), material.specular_colour ? 1.0f : 0.0f,
                     material.ambient_colour ? 1.0f : 0.0f, surface_error(surface)};
    const int layer = mirrors(plan_, surface) ? shop_.environment.first_layer(surface.object) : -1;
    texels[2 * i + 1] = {material.reflective, static_cast<float>(layer), 0.0f, 0.0f};
  }
  glGenTextures(1, &surface_table_);
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(surface_table_unit));
  glBindTexture(GL_TEXTURE_2D, surface_table_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(columns), static_cast<GLsizei>(rows), 0, GL_RGBA,
               GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void PictureDrawer::upload_volumes() {
  std::vector<const MeshBuffers*> buffers;
  for (const raster::DrawObject& object : plan_.objects) buffers.push_back(&shop_.meshes.get(object.mesh));
  for (std::size_t light = 0; light < plan_.lights.size(); ++light) {
    volumes_.emplace_back();
    for (const VolumeFaces& faces : volume_faces(plan_, light, places_, buffers)) volumes_.back().emplace_back(faces);
  }
}

}  // namespace ps::hardware
