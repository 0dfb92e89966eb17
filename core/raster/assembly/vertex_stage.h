#pragma once
#include <vector>

#include "base/parallel.h"
#include "raster/base/raster_inputs.h"
#include "raster/base/vertex_buffer.h"

namespace ps::raster {

/// What is made of the triangles afterwards.
enum class VertexUse {
  picture,  ///< all are drawn
  pixel     ///< those near one pixel are; the positions on the canvas show which
};

/// Model space to camera space for every vertex of every object that may be seen (CGFS ch. 10), and to world space for
/// those whose shading asks for it. With `camera-relative` positions are relative to the camera's before they are
/// rounded to Real, so pictures far from the origin do not shake. Objects culled by their bounding sphere get empty
/// buffers.
template <class Real>
std::vector<VertexBuffer<Real>> run_vertex_stage(const RasterInputs<Real>& inputs, const std::vector<bool>& culled,
                                                 VertexUse use, const ParallelOptions& parallel, Progress& progress);

/// What the shading of an object's surfaces asks of its vertices besides their place.
struct VertexNeeds {
  bool world = false;    ///< positions in world space
  bool normals = false;  ///< the vertices' own: for interpolation, at the vertices, or for a triangle's mean normal
};
template <class Real>
VertexNeeds vertex_needs(const RasterInputs<Real>& inputs, std::size_t object);

/// For each object whether its bounding sphere lies wholly outside a clipping plane (CGFS ch. 11, the first stage).
template <class Real>
std::vector<bool> cull_objects(const RasterInputs<Real>& inputs);

}  // namespace ps::raster
