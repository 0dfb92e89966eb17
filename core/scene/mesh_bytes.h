#pragma once
#include <cstdint>
#include <string>

#include "scene/scene.h"

namespace ps {

/// The bytes of triangle meshes in the two forms of CGPP 15.4, in the sizes of a graphics processor: 4 bytes a number.
struct MeshBytes {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;  ///< that differ in position, normal or texture coordinates
  std::uint64_t shared = 0;    ///< each vertex once, and three indices of 4 bytes a triangle
  std::uint64_t unshared = 0;  ///< three vertices a triangle, and no index
};

MeshBytes bytes_of_mesh(const Mesh& mesh);
/// All models of the scene together, each counted once however many instances place it.
MeshBytes bytes_of_meshes(const Scene& scene);
/// "8 vertices for 12 triangles: 240 bytes shared, 432 bytes unshared"; empty without triangles.
std::string mesh_bytes_text(const MeshBytes& bytes);

}  // namespace ps
