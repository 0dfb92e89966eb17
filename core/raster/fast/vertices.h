#pragma once
#include "raster/pass.h"

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
};

/// The results go to the same index; `world` may be nullptr.
using TransformPositions = void (*)(const VertexTransform& transform, const Vec3d* positions, std::size_t count,
                                    Vec4f* points, VertexPlace* places, Vec4f* world);
using TransformNormals = void (*)(const Mat3d& matrix, const Vec3d* normals, std::size_t count, Vec4f* result);

/// Repeat raster/vertex_stage.cpp and CanvasProjection::from_top_left to the last bit, several vertices at once.
struct VertexKernels {
  TransformPositions positions = nullptr;
  TransformNormals normals = nullptr;
};
VertexKernels vertex_kernels(Simd simd);

/// All vertices of all objects that are not culled; objects in the order of Pass::objects.
std::vector<VertexBuffer<float>> run_fast_vertices(const Pass<float>& pass, const std::vector<bool>& culled,
                                                   const ParallelOptions& parallel, Progress& progress);

}  // namespace ps::raster
