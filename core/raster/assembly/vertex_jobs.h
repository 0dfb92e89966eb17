#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace ps::raster {

/// A run of one object's positions or normals: what the vertex stage hands to a worker.
struct VertexJob {
  std::size_t object = 0;
  std::size_t first = 0, last = 0;
  bool normals = false;
};

/// Cuts the `count` positions or normals of an object into runs.
inline void add_vertex_jobs(std::vector<VertexJob>& jobs, std::size_t object, std::size_t count, bool normals) {
  constexpr std::size_t vertices_per_job = 8192;
  for (std::size_t first = 0; first < count; first += vertices_per_job)
    jobs.push_back({object, first, std::min(first + vertices_per_job, count), normals});
}

}  // namespace ps::raster
