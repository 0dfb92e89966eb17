#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "inspect/face_data.h"
#include "inspect/vertex_chain.h"

namespace ps {

/// A triangle that has a vertex as one of its corners.
struct CornerUse {
  int triangle = 0;
  int corner = 0;  ///< 0, 1 or 2
  FaceData face;
};

struct VertexUses {
  std::size_t count = 0;         ///< triangles at the vertex
  std::vector<CornerUse> first;  ///< the first of them
};

/// The triangles at a vertex that vertex_chain() accepts, the first `most` with what their faces say. None for models
/// of curved patches.
VertexUses vertex_uses(const Scene& scene, const VertexId& id, std::size_t most = 6);

/// "triangle 7: normal (0, 1, 0), uv (0.5, 0.5); Head, line 812 of robot.obj"
std::string use_text(const CornerUse& use);

}  // namespace ps
