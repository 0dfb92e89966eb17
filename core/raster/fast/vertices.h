#pragma once
#include "raster/base/raster_inputs.h"
#include "raster/base/vertex_buffer.h"

namespace ps::raster {

/// What the positions of one object are multiplied with.
struct VertexTransform {
  Mat3d linear{1.0};
  Vec3d translation{0, 0, 0};
  Mat3d from_world{1.0};
  Vec3d eye{0, 0, 0};
  CanvasProjection<float> projection;
  const ClipPlane<float>* planes = nullptr;
  std::size_t plane_count = 0;
  float subpixels = 256;  ///< in a pixel
  Mat3d normal_matrix{1.0};
};

/// Vertices of one object, one after the other.
struct VertexInput {
  const Vec3d* positions = nullptr;
  const Vec3d* normals = nullptr;  ///< only for VertexOutput::lit
  std::size_t count = 0;
};

/// The same members of VertexBuffer; the last two may be nullptr.
struct VertexOutput {
  Vec4f* points = nullptr;
  VertexPlace* places = nullptr;
  Vec4f* world = nullptr;
  Vec4f* lit = nullptr;
};

using TransformPositions = void (*)(const VertexTransform& transform, const VertexInput& input,
                                    const VertexOutput& output);
using TransformNormals = void (*)(const Mat3d& matrix, const Vec3d* normals, std::size_t count, Vec4f* result);

/// Repeat raster/assembly/vertex_stage.cpp and CanvasProjection::from_top_left to the last bit, several vertices at
/// once.
struct VertexKernels {
  TransformPositions positions = nullptr;
  TransformNormals normals = nullptr;
};
VertexKernels vertex_kernels(Simd simd);

/// All vertices of all objects that are not culled; objects in the order of RasterInputs::objects.
std::vector<VertexBuffer<float>> run_fast_vertices(const RasterInputs<float>& inputs, const std::vector<bool>& culled,
                                                   const ParallelOptions& parallel, Progress& progress);

}  // namespace ps::raster
