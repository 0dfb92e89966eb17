#include "raster/setup/mesh_corners.h"

namespace ps::raster {

MeshCorners make_mesh_corners(const Mesh& mesh) {
  MeshCorners corners;
  corners.positions.resize(mesh.triangles.size());
  std::uint32_t different = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const MeshTriangle& triangle = mesh.triangles[i];
    corners.positions[i] = triangle.position;
    for (std::size_t k = 0; k < 3; ++k)
      different |= triangle.position[k] ^ static_cast<std::uint32_t>(triangle.normal[k]);
  }
  corners.paired_normals = different == 0 && mesh.normals.size() == mesh.positions.size();
  return corners;
}

}  // namespace ps::raster
