#include "raster/fast/batch_drawer.h"

#include "math/has_nan.h"
#include "raster/assembly/set_up_triangle.h"
#include "raster/base/fast_path.h"
#include "raster/clear/coverage/of_triangle.h"
#include "raster/clear/draw_primitives.h"

namespace ps::raster {

BatchKernels batch_kernels(Simd simd) { return {scan_function(simd), shade_function(simd)}; }

BatchDrawer::BatchDrawer(const RasterInputs<float>& inputs, const PackedTextures& textures, const BatchKernels& kernels,
                         const ScreenGeometry<float>& geometry, Target<float>& target, CountingRecorder& recorder)
    : inputs_(inputs), textures_(textures), kernels_(kernels), geometry_(geometry), target_(target),
      recorder_(recorder), depth_buffer_(inputs.settings.visibility == Visibility::depth_buffer) {}

void BatchDrawer::draw(std::span<const PrimitiveRef> primitives) {
  for (std::size_t i = 0; i < primitives.size(); ++i)
    if (!draw_batched(primitives[i]))
      draw_primitives(inputs_, geometry_, primitives.subspan(i, 1), {DrawStage::whole, 0}, target_, recorder_);
}

bool BatchDrawer::draw_batched(const PrimitiveRef& ref) {
  const ScreenTriangle<float>& triangle = geometry_.batches[ref.batch].triangles[ref.index];
  const Surface<float>& surface = inputs_.surfaces[triangle.surface];
  if (!shades_in_lanes(surface) || !textures_.has_room_for(surface)) return false;
  const TileRect box = common_part(tested_box(inputs_, triangle), target_.rect());
  if (is_empty(box)) return true;
  setup_ = set_up_triangle(inputs_, geometry_, ref);
  const TriangleScan scan = triangle_scan(box);
  if (!can_scan(scan)) return false;
  const BatchShading shading = batch_shading();
  ScanCounts counts;
  std::uint64_t shaded = 0;
  for (int row = box.y0; row < box.y1;) {
    row = kernels_.scan(scan, row, batch_, counts);
    if (batch_.count == 0) continue;
    if (inputs_.channels != Channel::none) write_channels();
    kernels_.shade(shading, batch_);
    write_colours();
    shaded += static_cast<std::uint64_t>(batch_.count);
    batch_.count = 0;
  }
  recorder_.count(Counter::coverage_tests,
                  static_cast<std::uint64_t>(box.width()) * static_cast<std::uint64_t>(box.height()));
  count(counts, shaded);
  return true;
}

TriangleScan BatchDrawer::triangle_scan(const TileRect& box) const {
  TriangleScan scan;
  scan.edges = &setup_.edges;
  scan.box = box;
  scan.inverse_area = setup_.inverse_area;
  scan.inverse_z = setup_.triangle->inverse_z;
  scan.stored_depth = setup_.triangle->z;
  scan.depth_value = inputs_.settings.depth_value;
  scan.depth = depth_buffer_ ? &target_.depth(box.x0, box.y0) : nullptr;
  scan.depth_stride = target_.rect().width();
  scan.frame_width = target_.frame().width();
  return scan;
}

void BatchDrawer::write_colours() {
  Vec3f* const pixels = target_.frame().colour.pixels().data();
  bool nan = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
    const Vec3f colour(batch_.red[i], batch_.green[i], batch_.blue[i]);
    nan = nan || has_nan(colour);
    pixels[batch_.pixels[i]] = colour;
  }
  target_.note_nan(nan);
}

void BatchDrawer::write_channels() {
  const PixelId id = shown_id(setup_);
  Frame& frame = target_.frame();
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch_.count); ++i) {
    const auto pixel = static_cast<std::size_t>(batch_.pixels[i]);
    if (!frame.depth.empty()) frame.depth.pixels()[pixel] = batch_.z[i];
    if (!frame.ids.empty()) frame.ids.pixels()[pixel] = id;
  }
}

void BatchDrawer::count(const ScanCounts& counts, std::uint64_t shaded) {
  const AttributeLayout& layout = setup_.surface->layout;
  recorder_.count(Counter::fragments, counts.fragments);
  if (depth_buffer_) {
    recorder_.count(Counter::depth_tests, counts.fragments);
    recorder_.count(Counter::attributes_interpolated, counts.fragments);
    recorder_.count(Counter::depth_failures, counts.depth_failures);
  }
  recorder_.count(Counter::attributes_interpolated, shaded * static_cast<std::uint64_t>(layout.count));
  recorder_.count(Counter::pixels_written, shaded);
  recorder_.count(Counter::texel_reads, batch_.texels);
  batch_.texels = 0;
  if (!layout.lit || inputs_.settings.shading != Shading::phong) return;
  recorder_.count(Counter::shading_calls, shaded);
  recorder_.count(Counter::light_samples, shaded * inputs_.lights.size());
}

BatchTexture BatchDrawer::batch_texture() const {
  BatchTexture how;
  how.texture = textures_.of(*setup_.surface);
  how.filter = inputs_.settings.texture_filter;
  how.wrap = wrap_of((*inputs_.textures)[static_cast<std::size_t>(setup_.surface->material.texture)], inputs_.settings);
  how.uv = setup_.surface->layout.uv;
  how.mip_bias = static_cast<float>(inputs_.settings.mip_bias);
  const auto stride = static_cast<std::size_t>(setup_.surface->layout.count);
  const float* a = setup_.attributes + how.uv;
  for (std::size_t along = 0; along < 2; ++along) {
    const auto& step = along == 0 ? setup_.edges.step_x : setup_.edges.step_y;
    std::array<float, 3> change;
    for (std::size_t i = 0; i < 3; ++i) change[i] = static_cast<float>(step[i]) * setup_.inverse_area;
    how.steps[along] = {change[0] * a[0] + change[1] * a[stride] + change[2] * a[2 * stride],
                        change[0] * a[1] + change[1] * a[stride + 1] + change[2] * a[2 * stride + 1],
                        weighted(change, setup_.triangle->inverse_z)};
  }
  return how;
}

BatchShading BatchDrawer::batch_shading() const {
  const ShadingMaterial<float>& material = setup_.surface->material;
  const AttributeLayout& layout = setup_.surface->layout;
  BatchShading shading;
  shading.attributes = setup_.attributes;
  shading.stride = layout.count;
  shading.normal = layout.normal;
  shading.position = layout.position;
  shading.light = layout.light;
  shading.face_normal = setup_.triangle->face_normal;
  shading.eye = inputs_.eye;
  shading.colour = material.colour;
  shading.specular = inputs_.settings.specular && material.specular;
  shading.exponent = material.specular.value_or(1);
  shading.faint = faint_cosine(shading.exponent);
  shading.renormalise = inputs_.settings.renormalise;
  shading.highlight = inputs_.settings.highlight;
  shading.lights = inputs_.lights;
  if (layout.flat_light) shading.constant = flat_constant(setup_, 0);
  shading.source = light_source(layout);
  if (layout.uv != AttributeLayout::absent) shading.texture = batch_texture();
  return shading;
}

BatchLight BatchDrawer::light_source(const AttributeLayout& layout) const {
  if (!layout.lit) return BatchLight::none;
  switch (inputs_.settings.shading) {
  case Shading::phong:
    return BatchLight::equation;
  case Shading::gouraud:
    return BatchLight::corners;
  case Shading::flat:
    return BatchLight::constant;
  }
  return BatchLight::equation;
}

}  // namespace ps::raster
