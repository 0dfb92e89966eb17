#pragma once
#include <array>
#include <cstdint>

#include "base/block_store.h"
#include "scene/mesh.h"

namespace ps::raster {

/// The vertices of a mesh's triangles alone, a third as long as MeshTriangle: what the fast path reads of every
/// triangle in every frame.
struct MeshCorners {
  BlockVector<std::array<std::uint32_t, 3>> positions;  ///< indices into Mesh::positions, triangle after triangle
  /// Every vertex of a triangle has the normal of its position's number, so that one number finds both.
  bool paired_normals = false;

  std::size_t heap_bytes() const { return positions.capacity() * sizeof(positions[0]); }
};
MeshCorners make_mesh_corners(const Mesh& mesh);

}  // namespace ps::raster
