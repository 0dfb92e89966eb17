#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ps {

struct Mesh;

/// The indices that a model file gives a triangle, from 0; -1 = none.
struct FileIndices {
  std::array<std::int32_t, 3> uv{-1, -1, -1}, normal{-1, -1, -1};
  bool operator==(const FileIndices&) const = default;
};

/// Where the triangles of a mesh stand in its model file; empty for meshes from elsewhere. Four bytes a triangle, and a
/// few for each change of a name and for each triangle whose indices the mesh does not use.
struct FaceOrigins {
  std::vector<std::uint32_t> lines;  ///< of each triangle's face, from 1
  /// From `first_triangle` on faces belong to this object (`o`) and these groups (`g`), as indices into `names`.
  struct Run {
    std::uint32_t first_triangle = 0, object = 0, group = 0;
    bool operator==(const Run&) const = default;
  };
  std::vector<Run> runs;
  std::vector<std::string> names;
  std::uint32_t file_normals = 0, file_uvs = 0;  ///< how many the file holds; what lies behind them was computed
  std::vector<std::int32_t> moved_uvs;           ///< the file's index of each computed texture coordinate
  struct Unused {
    std::uint32_t triangle = 0;
    FileIndices indices;
    bool operator==(const Unused&) const = default;
  };
  std::vector<Unused> unused;  ///< in the order of the triangles
  bool operator==(const FaceOrigins&) const = default;

  /// The names before the triangle in the file; empty if there is none.
  const std::string& object_of(std::size_t triangle) const;
  const std::string& group_of(std::size_t triangle) const;
};

/// The indices that the file gives a triangle, of a mesh that has origins.
FileIndices file_indices(const Mesh& mesh, std::size_t triangle);

}  // namespace ps
