#include "raster/shadow/shadow_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/stop.h"
#include "math/unit.h"
#include "raster/shadow/shadow_map.h"

namespace ps::raster {
namespace {

using CornerIndex = std::uint32_t;
using Corners = std::array<CornerIndex, 3>;

/// World-space vertices in which equal positions are one vertex, so that edges are shared wherever triangles meet.
struct Welded {
  std::vector<Vec3d> positions;
  std::vector<std::uint32_t> source;   ///< of each, the first such vertex of the mesh
  std::vector<Corners> triangles;      ///< without those of zero area
  std::vector<std::uint32_t> numbers;  ///< of each of them, in the mesh
};

Welded weld(const DrawObject& object) {
  Welded welded;
  std::map<std::tuple<double, double, double>, CornerIndex> known;
  std::vector<CornerIndex> number;
  for (const Vec3d& model : object.mesh->positions) {
    if (number.size() % 1024 == 0) check_stop();
    const Vec3d p = object.world(model);
    const auto [entry, fresh] =
        known.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, static_cast<CornerIndex>(welded.positions.size()));
    if (fresh) {
      welded.positions.push_back(p);
      welded.source.push_back(static_cast<std::uint32_t>(number.size()));
    }
    number.push_back(entry->second);
  }
  for (std::size_t i = 0; i < object.mesh->triangles.size(); ++i) {
    const MeshTriangle& triangle = object.mesh->triangles[i];
    Corners c{number[triangle.position[0]], number[triangle.position[1]], number[triangle.position[2]]};
    if (object.mirrored) std::swap(c[1], c[2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    welded.triangles.push_back(c);
    welded.numbers.push_back(static_cast<std::uint32_t>(i));
  }
  return welded;
}

/// An edge, and how often it is run through from its lower to its higher vertex, less how often the other way.
struct BalancedEdge {
  CornerIndex low = 0, high = 0;
  int count = 0;
};

void add_edges(const Corners& triangle, std::vector<BalancedEdge>& edges) {
  for (std::size_t k = 0; k < 3; ++k) {
    const CornerIndex a = triangle[k], b = triangle[(k + 1) % 3];
    edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
  }
}

/// Each edge once, in the order of its vertices, with the sum of its counts: 0 for all edges of a closed surface. A
/// sphere seen from nearby has two hundred thousand of them, for each light; a tree of edges would take several times
/// as long as sorting.
std::vector<BalancedEdge> balanced(std::vector<BalancedEdge> edges) {
  std::sort(edges.begin(), edges.end(), [](const BalancedEdge& a, const BalancedEdge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  std::size_t last = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i].low == edges[last].low && edges[i].high == edges[last].high)
      edges[last].count += edges[i].count;
    else
      edges[++last] = edges[i];
  }
  if (!edges.empty()) edges.resize(last + 1);
  return edges;
}

bool is_closed(const Welded& welded) {
  std::vector<BalancedEdge> edges;
  edges.reserve(3 * welded.triangles.size());
  for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
    if (i % 1024 == 0) check_stop();
    add_edges(welded.triangles[i], edges);
  }
  edges = balanced(std::move(edges));
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.count == 0; });
}

bool faces(const Welded& welded, const Corners& triangle, const Light& light) {
  const Vec3d& a = welded.positions[triangle[0]];
  const Vec3d normal = cross(welded.positions[triangle[1]] - a, welded.positions[triangle[2]] - a);
  return dot(normal, light.kind == LightKind::point ? light.position - a : light.direction) > 0;
}

/// The triangles that cast the shadow, as numbers of welded ones.
std::vector<LitTriangle> lit_triangles(const Welded& welded, const Light& light) {
  std::vector<LitTriangle> lit, turned;
  for (std::uint32_t i = 0; i < welded.triangles.size(); ++i) {
    if (faces(welded, welded.triangles[i], light))
      lit.push_back({i, false});
    else
      turned.push_back({i, true});
  }
  // A light inside a closed model meets only backs.
  if (lit.empty() || !is_closed(welded)) lit.insert(lit.end(), turned.begin(), turned.end());
  return lit;
}

/// Its vertices in the order in which it faces the light.
Corners facing_light(const Welded& welded, const LitTriangle& lit) {
  const Corners& c = welded.triangles[lit.triangle];
  return lit.turned ? Corners{c[0], c[2], c[1]} : c;
}

/// Where a vertex ends up at the far end: away from the light. Without end all move by the same factor, so that flat
/// stays flat.
class Extrusion {
 public:
  Extrusion(const Welded& welded, const Light& light, const ShadowVolumeOptions& options)
      : light_(light), length_(options.length) {
    if (light.kind == LightKind::directional) {
      const Vec3d direction = float_direction(light.direction);
      shift_ = direction * (-options.length.value_or(options.reach) / length_of(direction));
      return;
    }
    double nearest = options.reach;
    for (const Vec3d& p : welded.positions) {
      nearest = std::min(nearest, length_of(p - light.position));
    }
    factor_ = options.reach / std::max(nearest, options.reach * 1e-7);
  }
  Vec3d operator()(const Vec3d& p) const {
    if (light_.kind == LightKind::directional) return p + shift_;
    const Vec3d away = p - light_.position;
    if (!length_) return light_.position + away * factor_;
    const double distance = length_of(away);
    return distance > 0 ? p + away * (*length_ / distance) : p;
  }

 private:
  const Light& light_;
  std::optional<double> length_;
  Vec3d shift_{0, 0, 0};
  double factor_ = 1;
};

MeshTriangle surface_triangle(CornerIndex a, CornerIndex b, CornerIndex c) {
  MeshTriangle triangle;
  triangle.position = {a, b, c};
  return triangle;
}

}  // namespace

ShadowVolume make_shadow_volume(const DrawObject& object, const Light& light, const ShadowVolumeOptions& options) {
  ShadowVolume volume;
  volume.object = object.object;
  auto surface = std::make_shared<Mesh>();
  if (light.kind != LightKind::ambient) {
    const Welded welded = weld(object);
    const Extrusion extrude(welded, light, options);
    surface->positions = welded.positions;
    for (const Vec3d& p : welded.positions) surface->positions.push_back(extrude(p));
    const auto far = [&](CornerIndex c) { return c + static_cast<CornerIndex>(welded.positions.size()); };
    std::vector<BalancedEdge> edges;
    volume.source = welded.source;
    for (const LitTriangle& lit : lit_triangles(welded, light)) {
      const Corners t = facing_light(welded, lit);
      volume.lit.push_back({welded.numbers[lit.triangle], lit.turned});
      if (volume.lit.size() % 1024 == 0) check_stop();
      add_edges(t, edges);
      if (!options.caps) continue;
      surface->triangles.push_back(surface_triangle(t[0], t[1], t[2]));
      surface->triangles.push_back(surface_triangle(far(t[0]), far(t[2]), far(t[1])));
    }
    volume.caps = surface->triangles.size();
    for (const auto& [low, high, count] : balanced(std::move(edges))) {
      const CornerIndex a = count > 0 ? low : high, b = count > 0 ? high : low;
      if (count != 0) volume.silhouette.push_back({welded.positions[a], welded.positions[b]});
      for (int i = 0; i < std::abs(count); ++i) {
        surface->triangles.push_back(surface_triangle(b, a, far(a)));
        surface->triangles.push_back(surface_triangle(b, far(a), far(b)));
        volume.edge_of_side.insert(volume.edge_of_side.end(), 2,
                                   static_cast<std::uint32_t>(volume.silhouette.size() - 1));
      }
    }
  }
  volume.surface = std::move(surface);
  return volume;
}

std::vector<std::vector<ShadowVolume>> make_shadow_volumes(const Scene& scene, const std::vector<DrawObject>& objects,
                                                           const Settings& settings) {
  ShadowVolumeOptions options;
  if (settings.volume_length > 0) options.length = settings.volume_length;
  options.reach = volume_reach * shadow_casters(scene).radius;
  options.caps = settings.volume_caps;
  std::vector<std::vector<ShadowVolume>> volumes;
  for (const Light& light : *scene.lights) {
    auto& of_light = volumes.emplace_back();
    if (light.kind == LightKind::ambient) continue;
    for (const DrawObject& object : objects)
      if (throws_shadow(scene, scene.geometry->objects[static_cast<std::size_t>(object.object)]))
        of_light.push_back(make_shadow_volume(object, light, options));
  }
  return volumes;
}

}  // namespace ps::raster
