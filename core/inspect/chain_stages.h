#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "inspect/vertex_chain.h"

namespace ps {

/// The spaces that a vertex passes through on its way from the model to the canvas, in this order.
enum class ChainSpace { model, world, camera, projection, canvas };
inline constexpr std::size_t chain_spaces = 5;

/// A model in every space on its vertices' way, for a film. Units: those of the model in `model`, world units in
/// `world` and `camera` (along right, up, forward), pixels from the centre with y up in `projection` and `canvas`. The
/// third component is the depth, in world units, up to `projection`; on the canvas it is 0.
struct ChainStages {
  std::array<std::vector<Vec3d>, chain_spaces> points;  ///< of the vertices that edges use, in the order of `vertices`
  std::vector<int> vertices;                            ///< indices into Mesh::positions
  std::vector<std::array<int, 2>> edges;                ///< of triangles, each once; indices into `vertices`
  int followed = 0;                                     ///< index into `vertices` of the vertex that was asked for
};

/// Follows the model of a vertex with vertex_chain(). Of large models only the first `most_edges` edges are there,
/// those at the vertex before all others. Edges with an end that is not in front of the camera have no place behind the
/// projection: they are left out. Throws InputError for a vertex that there is not.
ChainStages chain_stages(const Scene& scene, const View& view, const Settings& settings, const VertexId& id,
                         const VertexEdits& edits = {}, std::size_t most_edges = 1500);

/// Where a vertex of the stages is at a time: 0 = in the model, 1 = in the world, ... 4 = on the canvas; in between on
/// a straight line. `vertex` is an index into ChainStages::vertices.
Vec3d place_at(const ChainStages& stages, std::size_t vertex, double time);

}  // namespace ps
