#include "scene/face_origins.h"

#include <algorithm>

#include "scene/mesh.h"

namespace ps {
namespace {

const FaceOrigins::Run* run_of(const FaceOrigins& origins, std::size_t triangle) {
  const auto behind =
      std::upper_bound(origins.runs.begin(), origins.runs.end(), triangle,
                       [](std::size_t t, const FaceOrigins::Run& run) { return t < run.first_triangle; });
  return behind == origins.runs.begin() ? nullptr : &*(behind - 1);
}

const std::string no_name;

}  // namespace

const std::string& FaceOrigins::object_of(std::size_t triangle) const {
  const Run* run = run_of(*this, triangle);
  return run == nullptr ? no_name : names[run->object];
}

const std::string& FaceOrigins::group_of(std::size_t triangle) const {
  const Run* run = run_of(*this, triangle);
  return run == nullptr ? no_name : names[run->group];
}

FileIndices file_indices(const Mesh& mesh, std::size_t triangle) {
  const FaceOrigins& origins = mesh.origins;
  const auto unused =
      std::lower_bound(origins.unused.begin(), origins.unused.end(), triangle,
                       [](const FaceOrigins::Unused& entry, std::size_t t) { return entry.triangle < t; });
  if (unused != origins.unused.end() && unused->triangle == triangle) return unused->indices;
  FileIndices indices{mesh.triangles[triangle].uv, mesh.triangles[triangle].normal};
  for (std::int32_t& normal : indices.normal)
    if (normal >= static_cast<std::int32_t>(origins.file_normals)) normal = -1;
  for (std::int32_t& uv : indices.uv) {
    const auto file_uvs = static_cast<std::int32_t>(origins.file_uvs);
    if (uv >= file_uvs) uv = origins.moved_uvs[static_cast<std::size_t>(uv - file_uvs)];
  }
  return indices;
}

}  // namespace ps
