#include "raster/fast/resolve.h"

#include <algorithm>

#include "raster/corner_attributes.h"
#include "raster/fragment.h"

namespace ps::raster {
namespace {

/// Scalars are kept in fours, as the vectors of shade_batch.cpp are read.
constexpr int four = 4;

bool has_nan(const Vec3f& c) { return c.x != c.x || c.y != c.y || c.z != c.z; }

const PackedTexture* packed_texture(const Pass<float>& pass, const Surface<float>& surface) {
  if (!pass.packed_textures || surface.material.texture < 0) return nullptr;
  return &(*pass.packed_textures)[static_cast<std::size_t>(surface.material.texture)];
}

FastSurface fast_surface(const Pass<float>& pass, const Surface<float>& surface) {
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
  shading.eye = pass.eye;
  shading.colour = material.colour;
  shading.source = layout.lit ? BatchLight::equation : BatchLight::none;
  shading.specular = pass.settings.specular && material.specular;
  shading.exponent = material.specular.value_or(1);
  shading.renormalise = pass.settings.renormalise;
  shading.highlight = pass.settings.highlight;
  shading.lights = pass.lights;
  if (uv >= 0) {
    how.textured = true;
    shading.texture.texture = packed_texture(pass, surface);
    shading.texture.filter = pass.settings.texture_filter;
    shading.texture.wrap = pass.settings.texture_wrap;
    shading.texture.mip_bias = static_cast<float>(pass.settings.mip_bias);
    shading.texture.uv = uv;
    shading.steps_at = take(0);
    take(0);
  }
  shading.row_size = std::max(next, four);
  return how;
}

}  // namespace

std::vector<FastSurface> fast_surfaces(const Pass<float>& pass) {
  std::vector<FastSurface> surfaces;
  for (const Surface<float>& surface : pass.surfaces) surfaces.push_back(fast_surface(pass, surface));
  return surfaces;
}

void TileResolver::resolve(const TileFragments& tile, const TileRect& rect, Frame& frame, Counters& counters) {
  rows_.assign(tile.triangle_count, -1);
  used_ = 0;
  batch_.texels = 0;
  Vec3f* const pixels = frame.colour.pixels().data();
  const Vec3f background(pass_.scene->background);
  bool nan = has_nan(background);
  shade_replaced(tile);
  batch_.count = 0;
  for (int row = rect.y0; row < rect.y1; ++row) {
    kernels_.collect(tile, rect, row, background, pixels, frame.width(), batch_);
    if (row + 1 < rect.y1 && batch_.count + fast_tile <= ShadeBatch::capacity) continue;
    shade_fragments(tile);
    nan = kernels_.write(batch_, pixels) || nan;
    batch_.count = 0;
  }
  count(tile, counters);
  if (!nan) return;
  for (int row = rect.y0; row < rect.y1; ++row)
    for (int column = rect.x0; column < rect.x1; ++column)
      counters[Counter::nan_pixels] += has_nan(frame.colour.at(column, row)) ? 1u : 0u;
}

/// Nobody sees their colours, but the clear path has read the texture for them.
void TileResolver::shade_replaced(const TileFragments& tile) {
  batch_.count = 0;
  const auto flush = [&] {
    shade_fragments(tile);
    batch_.count = 0;
  };
  for (const ReplacedFragment& fragment : tile.replaced) {
    if (!surfaces_[tile.triangles[fragment.id].triangle->surface].textured) continue;
    const auto at = static_cast<std::size_t>(batch_.count++);
    for (std::size_t k = 0; k < 3; ++k) batch_.weights[k][at] = fragment.weights[k];
    batch_.z[at] = 1.0f / fragment.inverse_z;
    batch_.rows[at] = static_cast<std::int32_t>(fragment.id);
    if (batch_.count == ShadeBatch::capacity) flush();
  }
  flush();
}

/// Shades the batch, whose `rows` hold ids yet, in stretches of one surface.
void TileResolver::shade_fragments(const TileFragments& tile) {
  for (int first = 0; first < batch_.count;) {
    const auto id_at = [&](int i) { return static_cast<std::uint32_t>(batch_.rows[static_cast<std::size_t>(i)]); };
    const std::uint32_t surface = tile.triangles[id_at(first)].triangle->surface;
    std::uint32_t last_id = TileFragments::none;
    std::int32_t row = 0;
    int last = first;
    for (; last < batch_.count; ++last) {
      const std::uint32_t id = id_at(last);
      if (id != last_id) {
        const TileTriangle& triangle = tile.triangles[id];
        if (triangle.triangle->surface != surface) break;
        row = row_of(triangle, id);
        last_id = id;
      }
      batch_.rows[static_cast<std::size_t>(last)] = row;
    }
    BatchShading shading = surfaces_[surface].shading;
    shading.attributes = numbers_.data();
    pass_.shade_batch(shading, batch_, first, last);
    first = last;
  }
}

/// Rows of surfaces with different sizes lie in one piece of memory: each begins at a multiple of its own size.
std::int32_t TileResolver::row_of(const TileTriangle& triangle, std::uint32_t id) {
  std::int32_t& row = rows_[id];
  if (row >= 0) return row;
  const FastSurface& how = surfaces_[triangle.triangle->surface];
  const auto size = static_cast<std::size_t>(how.shading.row_size);
  row = static_cast<std::int32_t>((used_ + size - 1) / size);
  const std::size_t begin = static_cast<std::size_t>(row) * size;
  used_ = begin + size;
  if (numbers_.size() < used_) numbers_.resize(2 * used_ + 4096);
  fill_row(triangle, how, numbers_.data() + begin);
  return row;
}

void TileResolver::fill_row(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  fill_corners(triangle, how, row);
  if (how.shading.steps_at < 0) return;
  // What uv_derivatives() computes for the triangle as a whole.
  const FastTriangle& record = *triangle.triangle;
  TriangleEdges edges;
  float inverse_area = record.inverse_area;
  if (record.is_general()) {
    edges = *make_edges(triangle.part->cut.triangles[record.triangle].corners, pass_.grid);
    inverse_area = 1.0f / static_cast<float>(edges.area);
  } else {
    edges.step_x = {record.step_x[0], record.step_x[1], -record.step_x[0] - record.step_x[1]};
    edges.step_y = {record.step_y[0], record.step_y[1], -record.step_y[0] - record.step_y[1]};
  }
  const auto stride = static_cast<std::size_t>(how.corner_size);
  const float* a = row + how.shading.texture.uv;
  float* to = row + how.shading.steps_at;
  for (const auto& step : {edges.step_x, edges.step_y}) {
    std::array<float, 3> change;
    for (std::size_t i = 0; i < 3; ++i) change[i] = static_cast<float>(step[i]) * inverse_area;
    to[0] = change[0] * a[0] + change[1] * a[stride] + change[2] * a[2 * stride];
    to[1] = change[0] * a[1] + change[1] * a[stride + 1] + change[2] * a[2 * stride + 1];
    to[2] = weighted(change, record.inverse_z);
    to += four;
  }
}

void TileResolver::fill_corners(const TileTriangle& triangle, const FastSurface& how, float* row) const {
  const FastTriangle& record = *triangle.triangle;
  const BatchShading& shading = how.shading;
  const auto put = [](float* to, const Vec3f& value) {
    to[0] = value.x;
    to[1] = value.y;
    to[2] = value.z;
  };
  if (record.is_general()) {
    const ScreenTriangle<float>& piece = triangle.part->cut.triangles[record.triangle];
    const AttributeLayout& layout = pass_.surfaces[record.surface].layout;
    const float* from = triangle.part->cut.attributes.data() + piece.attributes;
    for (std::size_t k = 0; k < 3; ++k, row += how.corner_size, from += layout.count) {
      if (shading.normal >= 0) std::copy_n(from + layout.normal, 3, row + shading.normal);
      if (shading.position >= 0) std::copy_n(from + layout.position, 3, row + shading.position);
      if (how.textured) std::copy_n(from + layout.uv, 2, row + shading.texture.uv);
    }
    if (shading.face_normal_at >= 0) put(row - 3 * how.corner_size + shading.face_normal_at, piece.face_normal);
    return;
  }
  const DrawObject& object = pass_.objects[record.object];
  const MeshTriangle& mesh_triangle = object.mesh->triangles[record.triangle];
  CornerSource<float> source{object.mesh.get(), &mesh_triangle, &vertices_[record.object], {}};
  if (reads_face_normal(pass_, pass_.surfaces[record.surface], source))
    source.face_normal = face_normal<float>(object, mesh_triangle);
  if (shading.face_normal_at >= 0) put(row + shading.face_normal_at, source.face_normal);
  for (std::size_t k = 0; k < 3; ++k, row += how.corner_size) {
    const float share = record.inverse_z[k];
    if (shading.normal >= 0) put(row + shading.normal, source.normal(k, pass_.settings.normals) * share);
    if (shading.position >= 0) put(row + shading.position, source.position(k) * share);
    if (!how.textured) continue;
    const auto index = mesh_triangle.uv[k];
    const Vec2d uv = index >= 0 ? object.mesh->uvs[static_cast<std::size_t>(index)] : Vec2d(0);
    row[shading.texture.uv] = static_cast<float>(uv.x) * share;
    row[shading.texture.uv + 1] = static_cast<float>(uv.y) * share;
  }
}

void TileResolver::count(const TileFragments& tile, Counters& counters) const {
  std::uint64_t written = 0;
  for (std::size_t i = 0; i < tile.passed.size(); ++i) {
    const std::uint64_t passed = tile.passed[i];
    const AttributeLayout& layout = pass_.surfaces[i].layout;
    written += passed;
    counters[Counter::attributes_interpolated] += passed * static_cast<std::uint64_t>(layout.count);
    if (!layout.lit) continue;
    counters[Counter::shading_calls] += passed;
    counters[Counter::light_samples] += passed * pass_.lights.size();
  }
  counters[Counter::fragments] += tile.fragments;
  counters[Counter::depth_tests] += tile.fragments;
  counters[Counter::attributes_interpolated] += tile.fragments;
  counters[Counter::depth_failures] += tile.fragments - written;
  counters[Counter::pixels_written] += written;
  counters[Counter::texel_reads] += batch_.texels;
}

}  // namespace ps::raster
