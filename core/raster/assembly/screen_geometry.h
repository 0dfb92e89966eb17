#pragma once
#include <optional>
#include <vector>

#include "raster/assembly/assemble.h"
#include "raster/assembly/corner_attributes.h"
#include "raster/base/vertex_buffer.h"

namespace ps::raster {

/// All triangles or lines of a picture in drawing order, with what they were made from.
template <class Real>
struct ScreenGeometry {
  std::vector<VertexBuffer<Real>> vertices;  ///< one for each object
  std::vector<TriangleRun> runs;
  std::vector<Batch<Real>> batches;  ///< one for each run
  Counters counters;                 ///< of the vertex work, counted once
};

/// Vertex stage and primitive assembly. With an inspected pixel, batches keep what was rejected near it, and of whole
/// triangles that are drawn far from it only the number.
template <class Real>
ScreenGeometry<Real> make_geometry(const RasterInputs<Real>& inputs, std::optional<Vec2i> inspected,
                                   const ParallelOptions& parallel, Progress& progress);

/// The mesh triangle that a screen triangle came from.
template <class Real>
inline CornerSource<Real> corner_source(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                                        const ScreenTriangle<Real>& triangle) {
  const std::size_t object = inputs.surfaces[triangle.surface].drawn;
  const Mesh& mesh = *inputs.objects[object].mesh;
  return {&mesh, &mesh.triangles[static_cast<std::size_t>(triangle.triangle)], &geometry.vertices[object],
          triangle.face_normal};
}

/// Its vertices in camera space, before they were rounded to the canvas and before clipping.
template <class Real>
inline std::array<Vec3<Real>, 3> camera_corners(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                                                const ScreenTriangle<Real>& triangle) {
  const CornerSource<Real> source = corner_source(inputs, geometry, triangle);
  std::array<Vec3<Real>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = Vec3<Real>(source.vertices->camera[source.triangle->position[k]]);
  return corners;
}

}  // namespace ps::raster
