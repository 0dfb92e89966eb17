#pragma once
#include <optional>
#include <vector>

#include "raster/base/raster_inputs.h"
#include "raster/base/screen_triangle.h"
#include "raster/base/vertex_buffer.h"

namespace ps::raster {

/// Triangles [first, last) of one object; `sequence` numbers the first of them in drawing order.
struct TriangleRun {
  std::size_t object = 0;
  std::size_t first = 0, last = 0;
  std::uint32_t sequence = 0;
};

/// Cuts all objects into runs of a fixed size. Culled objects give none.
template <class Real>
std::vector<TriangleRun> make_runs(const RasterInputs<Real>& inputs, const std::vector<bool>& culled);

/// Primitive assembly for one run: facing, clipping, projection, and the attributes of the vertices. `inspected` is the
/// pixel (array position) whose story is recorded; without it nothing is kept of rejected triangles.
template <class Real>
Batch<Real> assemble(const RasterInputs<Real>& inputs, const VertexBuffer<Real>& vertices, const TriangleRun& run,
                     std::optional<Vec2i> inspected);

/// The same for a single triangle of an object, added to `batch` with its counts, without its number in drawing order.
template <class Real>
void assemble_triangle(const RasterInputs<Real>& inputs, const VertexBuffer<Real>& vertices, std::size_t object,
                       std::size_t triangle, Batch<Real>& batch);

}  // namespace ps::raster
