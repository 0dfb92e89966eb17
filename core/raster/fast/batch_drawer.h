#pragma once
#include <span>

#include "raster/assembly/screen_geometry.h"
#include "raster/base/target.h"
#include "raster/fast/packed_textures.h"
#include "raster/fast/scan_triangle.h"
#include "raster/fast/shade_batch.h"
#include "record/recorder.h"

namespace ps::raster {

/// The kernels for this setting on this processor.
struct BatchKernels {
  ScanTriangle scan = nullptr;
  ShadeFragments shade = nullptr;
};
BatchKernels batch_kernels(Simd simd);

/// One triangle after the other, its fragments with SIMD (Machinery::fragment_batches): coverage and depth of all
/// samples of its box in the tile, then the colours of those that passed. What the kernels do not shade or cannot count
/// exactly is drawn by the clear path (clear/draw_primitives.h), whose bits and counts all others repeat.
class BatchDrawer {
 public:
  BatchDrawer(const RasterInputs<float>& inputs, const PackedTextures& textures, const BatchKernels& kernels,
              const ScreenGeometry<float>& geometry, Target<float>& target, CountingRecorder& recorder);

  /// Draws triangles into the tile, in the order given.
  void draw(std::span<const PrimitiveRef> primitives);

 private:
  /// False if the clear path has to.
  bool draw_batched(const PrimitiveRef& ref);
  TriangleScan triangle_scan(const TileRect& box) const;
  BatchShading batch_shading() const;
  /// What uv_derivatives() computes for the triangle as a whole.
  BatchTexture batch_texture() const;
  BatchLight light_source(const AttributeLayout& layout) const;
  void write_colours();
  /// What the clear path writes of fast_channels, for all fragments of the batch.
  void write_channels();
  /// The same numbers that the clear path counts fragment by fragment.
  void count(const ScanCounts& counts, std::uint64_t shaded);

  const RasterInputs<float>& inputs_;
  const PackedTextures& textures_;
  BatchKernels kernels_;
  const ScreenGeometry<float>& geometry_;
  Target<float>& target_;
  CountingRecorder& recorder_;
  bool depth_buffer_;
  TriangleSetup<float> setup_;
  ShadeBatch batch_;
};

}  // namespace ps::raster
