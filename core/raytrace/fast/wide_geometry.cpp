#include "raytrace/fast/wide_geometry.h"

#include "accel/wide_octree.h"
#include "base/stop.h"

namespace ps {
namespace {

WideTriangle wide_triangle(const TracedGeometry<float>& geometry, std::uint32_t primitive) {
  const TracedTriangle<float>& triangle = geometry.triangles[geometry.primitives[primitive].shape];
  return {triangle.a, triangle.b, triangle.c, primitive};
}

WideGeometry seen_well(WideGeometry made, const TracedGeometry<float>& traced) {
  const SeenFrom<float> seen = see_from_well(made.triangles.nodes, made.others, traced);
  made.triangles.centre = seen.centre;
  made.reach = seen.reach;
  return made;
}

}  // namespace

SeenFrom<float> see_from_well(LargeArray<WideNode>& nodes, const Bvh<float>& others,
                              const TracedGeometry<float>& traced) {
  Box<float> box;
  if (!others.nodes.empty()) box = others.nodes[0].box;
  for (std::size_t slot = 0; slot < wide_width; ++slot)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], nodes[0].planes[2 * axis][slot]);
      box.high[axis] = std::max(box.high[axis], nodes[0].planes[2 * axis + 1][slot]);
    }
  const SeenFrom<float> seen = seen_from(box, traced.float_reach, traced.solids.empty());
  if (seen.centre != Vec3f(0)) see_from(seen.centre, nodes);
  return seen;
}

std::shared_ptr<const WideGeometry> wide_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                  Prepared& prepared) {
  Key key("wide geometry");
  key.add(scene.geometry.revision()).add(geometry.near_plane);
  return prepared.get<WideGeometry>(key, [&] {
    const auto triangle = [&](std::uint32_t primitive) { return wide_triangle(geometry, primitive); };
    std::vector<std::uint32_t> triangles, others;
    for (std::uint32_t k = 0; k < bounded_count(geometry); ++k) {
      const std::uint32_t i = bounded_primitive(geometry, k);
      (is_float_triangle(geometry.primitives[i]) ? triangles : others).push_back(i);
    }
    const Bvh<float> bvh = tree_over(geometry, triangles, {.group = block_width});
    return seen_well({widen(bvh, triangle), tree_over(geometry, others)}, geometry);
  });
}

std::shared_ptr<const WideGeometry> wide_octree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                         const Octree<float>& octree, const Settings& settings,
                                                         Prepared& prepared) {
  Key key("wide octree");
  key.add(scene.geometry.revision())
      .add(geometry.near_plane)
      .add(static_cast<std::uint64_t>(settings.octree_leaf))
      .add(static_cast<std::uint64_t>(settings.octree_depth));
  return prepared.get<WideGeometry>(key, [&] {
    std::vector<std::uint32_t> others;
    for (std::uint32_t k = 0; k < bounded_count(geometry); ++k) {
      const std::uint32_t i = bounded_primitive(geometry, k);
      if (!is_float_triangle(geometry.primitives[i])) others.push_back(i);
    }
    const auto triangle = [&](std::uint32_t primitive) -> std::optional<WideTriangle> {
      if (!is_float_triangle(geometry.primitives[primitive])) return {};
      return wide_triangle(geometry, primitive);
    };
    return seen_well({widen_octree(octree, triangle), tree_over(geometry, others)}, geometry);
  });
}

std::shared_ptr<const ListGeometry> list_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                  Prepared& prepared) {
  Key key("list geometry");
  key.add(scene.geometry.revision()).add(geometry.near_plane);
  return prepared.get<ListGeometry>(key, [&] {
    ListGeometry list;
    std::size_t triangles = 0;
    for (std::uint32_t i = 0; i < geometry.primitives.size(); ++i) {
      if (i % 4096 == 0) check_stop();
      if (!is_float_triangle(geometry.primitives[i])) {
        list.others.push_back(i);
        continue;
      }
      const std::size_t lane = triangles++ % block_width;
      if (lane == 0) list.triangles.blocks.emplace_back().clear();
      list.triangles.blocks.back().put(lane, wide_triangle(geometry, i));
    }
    return list;
  });
}

}  // namespace ps
