#include "raster/fast/attribute_rows.h"

#include <algorithm>
#include <cstring>

#include "hwy/cache_control.h"
#include "raster/assembly/corner_attributes.h"
#include "raster/base/fragment.h"

namespace ps::raster {
namespace {

/// Scalars are kept in fours, as vectors read them.
constexpr int four = 4;

FastSurface fast_surface(const RasterInputs<float>& inputs, const PackedTextures& textures,
                         const Surface<float>& surface) {
  const ShadingMaterial<float>& material = surface.material;
  const AttributeLayout& layout = surface.layout;
  FastSurface how;
  int next = 0;
  const auto take = [&](int slot) {
    if (slot == AttributeLayout::absent) return -1;
    next += four;
    return next - four;
  };
  BatchShading& shading = how.shading;
  shading.normal = take(layout.normal);
  shading.position = take(layout.position);
  const int uv = take(layout.uv);
  how.corner_size = next;
  shading.stride = next;
  next *= 3;
  if (layout.shading_normal && layout.normal == AttributeLayout::absent) shading.face_normal_at = take(0);
  shading.eye = inputs.eye;
  shading.colour = material.colour;
  shading.source = layout.lit ? BatchLight::equation : BatchLight::none;
  shading.specular = inputs.settings.specular && material.specular;
  shading.exponent = material.specular.value_or(1);
  shading.faint = faint_cosine(shading.exponent);
  shading.renormalise = inputs.settings.renormalise;
  shading.highlight = inputs.settings.highlight;
  shading.lights = inputs.lights;
  if (uv >= 0) {
    how.textured = true;
    shading.texture.texture = textures.of(surface);
    shading.texture.filter = inputs.settings.texture_filter;
    shading.texture.wrap =
        wrap_of((*inputs.textures)[static_cast<std::size_t>(surface.material.texture)], inputs.settings);
    shading.texture.mip_bias = static_cast<float>(inputs.settings.mip_bias);
    shading.texture.uv = uv;
    shading.steps_at = take(0);
    take(0);
  }
  how.row_size = std::max(next, four);
  return how;
}

}  // namespace

std::vector<FastSurface> fast_surfaces(const RasterInputs<float>& inputs, const PackedTextures& textures) {
  std::vector<FastSurface> surfaces;
  for (const Surface<float>& surface : inputs.surfaces) surfaces.push_back(fast_surface(inputs, textures, surface));
  return surfaces;
}

namespace {

/// Changes of the weights along x and along y, as uv_derivatives() takes them.
std::array<std::array<float, 3>, 2> weight_steps(const std::array<std::array<std::int64_t, 3>, 2>& steps,
                                                 float inverse_area) {
  std::array<std::array<float, 3>, 2> changes;
  for (std::size_t along = 0; along < 2; ++along)
    for (std::size_t i = 0; i < 3; ++i) changes[along][i] = static_cast<float>(steps[along][i]) * inverse_area;
  return changes;
}

/// Samples that mostly show one triangle, or nothing.
constexpr std::size_t run = 16;
static_assert(TileFragments::samples % run == 0);

/// From this number of triangles in a tile on, the order in which their vertices are read matters.
constexpr std::uint32_t enough_to_sort = 256;

bool all_are(std::uint32_t id, const std::uint32_t* ids) {
  std::uint32_t different = 0;
  for (std::size_t i = 0; i < run; ++i) different |= ids[i] ^ id;
  return different == 0;
}

}  // namespace

void AttributeRows::start(const TileFragments& tile) {
  tile_ = &tile;
  const std::uint32_t count = tile.triangle_count;
  begin_.assign(count + 1, missing);  // the last one is for samples that show nothing
  used_ = 0;
  if (count < enough_to_sort) return;
  static_assert(TileFragments::none == 0xffffffff);
  for (std::size_t first = 0; first < TileFragments::samples; first += run) {
    if (all_are(tile.id[first], tile.id.data() + first)) {
      begin_[std::min(tile.id[first], count)] = seen;
      continue;
    }
    for (std::size_t i = first; i < first + run; ++i) begin_[std::min(tile.id[i], count)] = seen;
  }
  constexpr std::uint32_t ahead = 16, vertices_ahead = 8;
  for (std::uint32_t id = 0; id < count; ++id) {
    if (id + ahead < count && begin_[id + ahead] == seen) fetch(tile.triangles[id + ahead]);
    if (id + vertices_ahead < count && begin_[id + vertices_ahead] == seen)
      fetch_vertices(tile.triangles[id + vertices_ahead]);
    if (begin_[id] == seen) make_row(id);
  }
}

/// The triangle will soon be read.
void AttributeRows::fetch(const TileTriangle& triangle) const {
  if (triangle.triangle->is_general()) return;
  const FastTriangle& origin = *triangle.triangle;
  hwy::Prefetch(&inputs_.objects[origin.object].corners->positions[origin.triangle]);
  if (vertices_[origin.object].lit.empty())
    hwy::Prefetch(&inputs_.objects[origin.object].mesh->triangles[origin.triangle]);
}

/// The same for its vertices; fetch() has been called some time ago.
void AttributeRows::fetch_vertices(const TileTriangle& triangle) const {
  if (triangle.triangle->is_general()) return;
  const FastTriangle& origin = *triangle.triangle;
  const VertexBuffer<float>& vertices = vertices_[origin.object];
  if (!vertices.lit.empty()) {
    for (const std::uint32_t v : inputs_.objects[origin.object].corners->positions[origin.triangle])
      hwy::Prefetch(&vertices.lit[std::size_t{2} * v]);
    return;
  }
  const MeshTriangle& mesh_triangle = inputs_.objects[origin.object].mesh->triangles[origin.triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    hwy::Prefetch(vertices.world.empty() ? &vertices.camera[mesh_triangle.position[k]]
                                         : &vertices.world[mesh_triangle.position[k]]);
    if (!vertices.normals.empty() && mesh_triangle.normal[k] >= 0)
      hwy::Prefetch(&vertices.normals[static_cast<std::size_t>(mesh_triangle.normal[k])]);
  }
}

std::uint32_t AttributeRows::make_row(std::uint32_t id) {
  const TileTriangle& triangle = tile_->triangles[id];
  const FastSurface& how = surfaces_[triangle.surface()];
  const auto begin = static_cast<std::uint32_t>(used_);
  used_ += static_cast<std::size_t>(how.row_size);
  if (numbers_.size() < used_) numbers_.resize(2 * used_ + 4096);
  float* const row = numbers_.data() + begin;
  if (how.corner_size == 0 && how.shading.face_normal_at < 0) return begin_[id] = begin;
  if (triangle.triangle->is_general())
    fill_piece(triangle, how, row);
  else
    fill_from_vertices(triangle, how, row);
  if (how.shading.steps_at >= 0) fill_steps(triangle, how, row);
  return begin_[id] = begin;
}

void AttributeRows::fill_from_vertices(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  static_assert(2 * sizeof(Vec4f) == 2 * four * sizeof(float));
  if (how.shading.normal == 0 && how.shading.position == four && !vertices_[triangle.triangle->object].lit.empty())
    fill_lit(triangle, how, row);
  else if (how.shading.normal >= 0 || how.shading.position >= 0 || how.shading.face_normal_at >= 0)
    fill_corners(triangle, how, row);
  if (how.textured) fill_uvs(triangle, how, row);
}

/// What uv_derivatives() computes for the triangle as a whole.
void AttributeRows::fill_steps(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  std::array<std::array<float, 3>, 2> changes;
  std::array<float, 3> inverse_z;
  if (triangle.triangle->is_general()) {
    const LargeTriangle& large = triangle.part->large[triangle.triangle->triangle];
    changes = weight_steps({large.edges.step_x, large.edges.step_y}, large.inverse_area);
    inverse_z = triangle.triangle->inverse_z;
  } else {
    const FastTriangle& record = *triangle.triangle;
    const auto three = [](const std::array<std::int32_t, 2>& step) {
      return std::array<std::int64_t, 3>{step[0], step[1], -std::int64_t{step[0]} - step[1]};
    };
    changes = weight_steps({three(record.step_x), three(record.step_y)}, record.inverse_area);
    inverse_z = record.inverse_z;
  }
  const auto stride = static_cast<std::size_t>(how.corner_size);
  const float* a = row + how.shading.texture.uv;
  float* to = row + how.shading.steps_at;
  for (const std::array<float, 3>& change : changes) {
    to[0] = change[0] * a[0] + change[1] * a[stride] + change[2] * a[2 * stride];
    to[1] = change[0] * a[1] + change[1] * a[stride + 1] + change[2] * a[2 * stride + 1];
    to[2] = weighted(change, inverse_z);
    to += four;
  }
}

/// A piece of a triangle that something cut carries what the clear path gave it.
void AttributeRows::fill_piece(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  const FastTriangle& record = *triangle.triangle;
  const BatchShading& shading = how.shading;
  const ScreenTriangle<float>& piece = triangle.part->cut.triangles[record.triangle];
  const AttributeLayout& layout = inputs_.surfaces[record.surface].layout;
  if (shading.face_normal_at >= 0) {
    float* const to = row + shading.face_normal_at;
    for (int axis = 0; axis < 3; ++axis) to[axis] = piece.face_normal[axis];
  }
  const float* from = triangle.part->cut.attributes.data() + piece.attributes;
  for (std::size_t k = 0; k < 3; ++k, row += how.corner_size, from += layout.count) {
    if (shading.normal >= 0) std::copy_n(from + layout.normal, 3, row + shading.normal);
    if (shading.position >= 0) std::copy_n(from + layout.position, 3, row + shading.position);
    if (how.textured) std::copy_n(from + layout.uv, 2, row + shading.texture.uv);
  }
}

/// The vertex stage has made the numbers of a vertex as they are in the row.
void AttributeRows::fill_lit(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  const FastTriangle& origin = *triangle.triangle;
  const Vec4f* const lit = vertices_[origin.object].lit.data();
  for (const std::uint32_t v : inputs_.objects[origin.object].corners->positions[origin.triangle]) {
    std::memcpy(row, lit + std::size_t{2} * v, 2 * sizeof(Vec4f));
    row += how.corner_size;
  }
}

void AttributeRows::fill_corners(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  const FastTriangle& origin = *triangle.triangle;
  const BatchShading& shading = how.shading;
  const DrawObject& object = inputs_.objects[origin.object];
  const MeshTriangle& mesh_triangle = object.mesh->triangles[origin.triangle];
  const VertexBuffer<float>& vertices = vertices_[origin.object];
  CornerSource<float> source{object.mesh.get(), &mesh_triangle, &vertices, {}};
  if (reads_face_normal(inputs_, inputs_.surfaces[origin.surface], source))
    source.face_normal = face_normal<float>(object, mesh_triangle);
  if (shading.face_normal_at >= 0) {
    float* const to = row + shading.face_normal_at;
    for (int axis = 0; axis < 3; ++axis) to[axis] = source.face_normal[axis];
  }
  for (std::size_t k = 0; k < 3; ++k, row += how.corner_size) {
    const float share = vertices.camera[mesh_triangle.position[k]].w;
    const auto put = [&](int slot, const Vec3f& value) {
      if (slot < 0) return;
      for (int axis = 0; axis < 3; ++axis) row[slot + axis] = value[axis] * share;
    };
    if (shading.normal >= 0) put(shading.normal, source.normal(k, inputs_.settings.normals));
    if (shading.position >= 0) put(shading.position, source.position(k));
  }
}

void AttributeRows::fill_uvs(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  const FastTriangle& origin = *triangle.triangle;
  const Mesh& mesh = *inputs_.objects[origin.object].mesh;
  const MeshTriangle& mesh_triangle = mesh.triangles[origin.triangle];
  for (std::size_t k = 0; k < 3; ++k, row += how.corner_size) {
    const float share = vertices_[origin.object].camera[mesh_triangle.position[k]].w;
    const auto index = mesh_triangle.uv[k];
    const Vec2d uv = index >= 0 ? mesh.uvs[static_cast<std::size_t>(index)] : Vec2d(0);
    row[how.shading.texture.uv] = static_cast<float>(uv.x) * share;
    row[how.shading.texture.uv + 1] = static_cast<float>(uv.y) * share;
  }
}

}  // namespace ps::raster
