#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "math/vec.h"
#include "scene/face_origins.h"
#include "scene/patch.h"

namespace ps {

/// One vertex list of a mesh triangle: indices into the mesh's arrays.
struct MeshTriangle {
  std::array<std::uint32_t, 3> position{};
  std::array<std::int32_t, 3> normal{-1, -1, -1};  ///< -1 = no vertex normal
  std::array<std::int32_t, 3> uv{-1, -1, -1};      ///< -1 = no texture coordinate
  std::uint32_t material = 0;                      ///< index into Mesh::materials
  bool operator==(const MeshTriangle&) const = default;
};

/// Triangles in model space (CGFS ch. 10: a model). Stored once, however many instances place it.
struct Mesh {
  std::string name;
  std::vector<Vec3d> positions;
  std::vector<Vec3d> normals;  ///< vertex normals as the source gives them, not normalised here
  std::vector<Vec2d> uvs;      ///< v = 0 is the top row of a picture, as in the book
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> materials;  ///< indices into Scene::materials, one for each material slot
  std::string source;                    ///< the model file that it was read from; empty if a scene file spells it out
  FaceOrigins origins;                   ///< where the triangles stand in that file
  std::vector<BezierPatch> patches;      ///< the curved surface that the triangles approximate, if any
  bool operator==(const Mesh&) const = default;
};

/// A sphere around all vertices of triangles: its centre is that of their bounding box (CGFS ch. 11). Vertices that no
/// triangle uses do not count.
struct BoundingSphere {
  Vec3d centre{0, 0, 0};
  double radius = 0;
};
BoundingSphere bounding_sphere(const Mesh& mesh);

}  // namespace ps
