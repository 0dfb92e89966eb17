#include "raytrace/base/two_level.h"

#include <cmath>

namespace ps {
namespace {

/// Bounding box of the primitives in a range of numbers; empty for unbounded ones, and for instances that no ray can
/// hit.
template <class Real>
Box<Real> range_box(const TracedGeometry<Real>& geometry, const NumberRange& range) {
  switch (range.kind) {
  case NumberRange::Kind::instance: {
    const Box<double>& box = geometry.instances[range.index].box;
    return {Vec3<Real>(box.low), Vec3<Real>(box.high)};
  }
  case NumberRange::Kind::primitive: {
    const Primitive& primitive = geometry.primitives[range.index];
    if (primitive.kind == PrimitiveKind::solid && geometry.solids[primitive.shape].unbounded) return {};
    return primitive_box(geometry, primitive);
  }
  }
  return {};
}

/// Adds a vertex to a box in the model's space, rounded outwards.
template <class Real>
void include_rounded(const Vec3d& corner, Box<Real>& box) {
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const Real near = static_cast<Real>(corner[axis]);
    const double value = static_cast<double>(near);
    box.low[axis] = std::min(box.low[axis], value > corner[axis] ? std::nextafter(near, -infinity) : near);
    box.high[axis] = std::max(box.high[axis], value < corner[axis] ? std::nextafter(near, infinity) : near);
  }
}

template <class Real>
Bvh<Real> model_tree(const Mesh& mesh) {
  std::vector<Box<Real>> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const std::uint32_t corner : mesh.triangles[i].position) include_rounded(mesh.positions[corner], boxes[i]);
  return build_bvh<Real>(boxes);
}

template <class Real>
int levels_below(const Bvh<Real>& tree, std::uint32_t node) {
  const BvhNode<Real>& here = tree.nodes[node];
  if (here.count > 0) return 1;
  return 1 + std::max(levels_below(tree, here.first), levels_below(tree, here.first + 1));
}

template <class Real>
TwoLevel<Real> build_two_level(const TracedGeometry<Real>& geometry) {
  TwoLevel<Real> trees;
  trees.models.resize(geometry.meshes.size());
  std::vector<Box<double>> corners(geometry.meshes.size());
  std::vector<bool> placed(geometry.meshes.size());
  for (const PlacedInstance& instance : geometry.instances) {
    const Mesh& mesh = *geometry.meshes[instance.mesh];
    if (!placed[instance.mesh]) {
      placed[instance.mesh] = true;
      trees.models[instance.mesh] = model_tree<Real>(mesh);
      for (const Vec3d& position : mesh.positions) corners[instance.mesh].include(position);
    }
    trees.into.push_back(into_model(instance.transform, corners[instance.mesh]));
  }
  std::vector<Box<Real>> boxes;
  std::vector<std::uint32_t> entries;
  for (std::uint32_t i = 0; i < geometry.numbers.size(); ++i) {
    const Box<Real> box = range_box(geometry, geometry.numbers[i]);
    if (box.empty()) continue;
    boxes.push_back(box);
    entries.push_back(i);
  }
  trees.top = build_bvh<Real>(boxes);
  for (std::uint32_t& entry : trees.top.order) entry = entries[entry];
  if (!trees.top.nodes.empty()) trees.top_levels = levels_below(trees.top, 0);
  return trees;
}

}  // namespace

template <class Real>
std::shared_ptr<const TwoLevel<Real>> two_level(const Scene& scene, const TracedGeometry<Real>& geometry,
                                                Prepared& prepared) {
  Key key("two levels");
  key.add(scene.geometry.revision()).add(std::uint64_t{sizeof(Real)});
  return prepared.get<TwoLevel<Real>>(key, [&] { return build_two_level(geometry); });
}

template std::shared_ptr<const TwoLevel<float>> two_level(const Scene&, const TracedGeometry<float>&, Prepared&);
template std::shared_ptr<const TwoLevel<double>> two_level(const Scene&, const TracedGeometry<double>&, Prepared&);

}  // namespace ps
