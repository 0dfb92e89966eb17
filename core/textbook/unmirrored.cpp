#include "textbook/unmirrored.h"

#include <utility>

#include "scene/world.h"

namespace ps {

std::optional<Unmirrored> unmirrored(const Mesh& mesh, const Instance& instance) {
  const Transform& t = instance.transform;
  const bool odd = mirrors(t);
  Vec3d sense{t.scale.x < 0 ? -1.0 : 1.0, t.scale.y < 0 ? -1.0 : 1.0, t.scale.z < 0 ? -1.0 : 1.0};
  Unmirrored result{{}, instance};
  result.instance.transform.scale = t.scale * sense;
  const bool rotation_mirrors = odd != (sense.x * sense.y * sense.z < 0);
  if (sense == Vec3d{1, 1, 1} && !rotation_mirrors) return {};
  if (rotation_mirrors) {
    result.instance.transform.rotation[0] = -t.rotation[0];
    sense.x = -sense.x;
  }
  result.mesh = mesh;
  result.mesh.patches.clear();
  for (Vec3d& position : result.mesh.positions) position *= sense;
  for (Vec3d& normal : result.mesh.normals) normal *= sense;
  if (odd)
    for (MeshTriangle& triangle : result.mesh.triangles) {
      std::swap(triangle.position[1], triangle.position[2]);
      std::swap(triangle.normal[1], triangle.normal[2]);
      std::swap(triangle.uv[1], triangle.uv[2]);
    }
  return result;
}

}  // namespace ps
