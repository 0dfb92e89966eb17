#pragma once
#include <functional>
#include <optional>

#include "accel/octree.h"
#include "accel/wide_bvh.h"

namespace ps {

/// The triangles of an octree as single rays search them with SIMD: a cell's eight children are the eight boxes of a
/// node. Cells are cut down to what they hold, and a cell with one child is passed over; a triangle is still listed in
/// every leaf that it touches. `triangle(i)` is called for the octree's entries and returns nullopt for entries that
/// are not triangles.
using TriangleOfEntry = std::function<std::optional<WideTriangle>(std::uint32_t entry)>;
WideBvh widen_octree(const Octree<float>& octree, const TriangleOfEntry& triangle);

}  // namespace ps
