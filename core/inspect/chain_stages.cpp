#include "inspect/chain_stages.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ps {
namespace {

using Edge = std::array<int, 2>;  // of a mesh, the lower index first

/// Each edge of the triangles once, those at `vertex` first.
std::vector<Edge> edges_of(const Mesh& mesh, int vertex, std::size_t most) {
  std::set<Edge> known;
  std::vector<Edge> edges;
  for (const bool at_vertex : {true, false})
    for (const MeshTriangle& triangle : mesh.triangles)
      for (std::size_t i = 0; i < 3 && edges.size() < most; ++i) {
        const int a = static_cast<int>(triangle.position[i]), b = static_cast<int>(triangle.position[(i + 1) % 3]);
        if ((a == vertex || b == vertex) != at_vertex) continue;
        if (const Edge edge{std::min(a, b), std::max(a, b)}; known.insert(edge).second) edges.push_back(edge);
      }
  return edges;
}

}  // namespace

ChainStages chain_stages(const Scene& scene, const View& view, const Settings& settings, const VertexId& id,
                         const VertexEdits& edits, std::size_t most_edges) {
  vertex_chain(scene, view, settings, id, edits);  // throws for a vertex that there is not
  const auto& instance = std::get<Instance>(scene.geometry->objects[static_cast<std::size_t>(id.object)].shape);
  const Mesh& mesh = *scene.geometry->meshes[instance.mesh];
  ChainStages stages;
  std::map<int, int> place_of;  // of a mesh's vertex in stages.vertices; -1: not in front of the camera
  const auto add = [&](int vertex) {
    const auto [found, fresh] = place_of.try_emplace(vertex, -1);
    if (!fresh) return found->second;
    const VertexChain chain = vertex_chain(scene, view, settings, {id.object, vertex}, edits);
    if (!(chain.camera.z > 0) && vertex != id.vertex) return -1;
    found->second = static_cast<int>(stages.vertices.size());
    stages.vertices.push_back(vertex);
    const Vec3d flat{chain.centred, 0};
    const std::array places{chain.model, chain.world, chain.camera, Vec3d(chain.centred, chain.camera.z), flat};
    for (std::size_t space = 0; space < chain_spaces; ++space) stages.points[space].push_back(places[space]);
    return found->second;
  };
  stages.followed = add(id.vertex);
  for (const Edge& edge : edges_of(mesh, id.vertex, most_edges)) {
    const int a = add(edge[0]), b = add(edge[1]);
    if (a >= 0 && b >= 0) stages.edges.push_back({a, b});
  }
  return stages;
}

Vec3d place_at(const ChainStages& stages, std::size_t vertex, double time) {
  const double at = std::clamp(time, 0.0, static_cast<double>(chain_spaces - 1));
  const auto space = std::min(static_cast<std::size_t>(at), chain_spaces - 2);
  const double share = at - static_cast<double>(space);
  return stages.points[space][vertex] * (1 - share) + stages.points[space + 1][vertex] * share;
}

}  // namespace ps
