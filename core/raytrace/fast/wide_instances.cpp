#include "raytrace/fast/wide_instances.h"

#include <algorithm>

namespace ps {
namespace {

/// Turns a tree of two-wide nodes over instances into one of eight-wide nodes whose leaves are single instances, always
/// opening the child of the largest area.
class TopBuilder {
 public:
  TopBuilder(const Bvh<float>& bvh, const std::vector<Box<float>>& boxes) : bvh_(bvh), boxes_(boxes) {}

  LargeArray<WideNode> build() {
    nodes_.push_back(empty_wide_node());
    if (!bvh_.nodes.empty()) fill(0, bvh_.nodes[0]);
    return std::move(nodes_);
  }

 private:
  using Child = BvhNode<float>;  ///< a leaf may be a part of one

  Child part(std::uint32_t first, std::uint32_t count) const {
    Child child{{}, first, count};
    for (std::uint32_t i = first; i < first + count; ++i) child.box.include(boxes_[bvh_.order[i]]);
    return child;
  }
  std::array<Child, 2> opened(const Child& child) const {
    if (child.count == 0) return {bvh_.nodes[child.first], bvh_.nodes[child.first + 1]};
    const std::uint32_t half = child.count / 2;
    return {part(child.first, half), part(child.first + half, child.count - half)};
  }

  void fill(std::size_t place, const Child& tree) {
    std::vector<Child> children{tree};
    while (children.size() < wide_width) {
      Child* largest = nullptr;
      for (Child& child : children)
        if (child.count != 1 && (largest == nullptr || child.box.half_area() > largest->box.half_area()))
          largest = &child;
      if (largest == nullptr) break;
      const std::array<Child, 2> two = opened(*largest);
      *largest = two[0];
      children.push_back(two[1]);
    }
    for (std::size_t i = 0; i < children.size(); ++i) put_box(nodes_[place], i, children[i].box);
    order_children(nodes_[place], children.size());
    for (std::size_t i = 0; i < children.size(); ++i) {
      const Child& child = children[i];
      if (child.count == 1) {
        nodes_[place].child[i] = wide_leaf(bvh_.order[child.first] + 1, 1);
        continue;
      }
      nodes_[place].child[i] = static_cast<WideChild>(nodes_.size());
      nodes_.push_back(empty_wide_node());
      fill(nodes_.size() - 1, child);
    }
  }

  const Bvh<float>& bvh_;
  const std::vector<Box<float>>& boxes_;
  LargeArray<WideNode> nodes_;
};

WideModel wide_model(const Mesh& mesh, const Bvh<float>& tree) {
  WideModel model;
  std::vector<BlockRange> ranges;
  model.nodes = widen_nodes(tree, ranges, 0);
  model.blocks.resize(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ModelBlock& block = model.blocks[i];
    for (std::uint32_t lane = 0; lane < block_width; ++lane) {
      const bool used = lane < ranges[i].count;
      block.triangle[lane] = used ? tree.order[ranges[i].first + lane] : no_primitive;
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis)
          block.corner[corner][axis][lane] =
              used ? mesh.positions[mesh.triangles[block.triangle[lane]].position[corner]][axis]
                   : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return model;
}

WideInstances make_wide_instances(const TracedGeometry<float>& geometry, const TwoLevel<float>& trees) {
  WideInstances wide;
  wide.models.resize(geometry.meshes.size());
  std::vector<Box<float>> boxes;
  for (std::size_t i = 0; i < geometry.instances.size(); ++i) {
    const PlacedInstance& placed = geometry.instances[i];
    const Mesh& mesh = *geometry.meshes[placed.mesh];
    WideModel& model = wide.models[placed.mesh];
    if (model.nodes.empty()) model = wide_model(mesh, trees.models[placed.mesh]);
    if (placed.box.empty()) continue;  // no triangle with an area
    wide.instances.push_back({placed.mesh, placed.first, static_cast<std::uint32_t>(mesh.triangles.size()),
                              placed.in_double, trees.into[i], placed.transform});
    boxes.push_back({Vec3f(placed.box.low), Vec3f(placed.box.high)});
  }
  const Bvh<float> top = build_bvh<float>(boxes);
  wide.top = TopBuilder(top, boxes).build();
  std::vector<std::uint32_t> others;
  for (const NumberRange& range : geometry.numbers)
    if (range.kind == NumberRange::Kind::primitive &&
        !std::binary_search(geometry.unbounded.begin(), geometry.unbounded.end(), range.first))
      others.push_back(range.first);
  wide.others = tree_over(geometry, others);
  wide.seen = see_from_well(wide.top, wide.others, geometry);
  return wide;
}

}  // namespace

std::shared_ptr<const WideInstances> wide_instances(const Scene& scene, const TracedGeometry<float>& geometry,
                                                    const TwoLevel<float>& trees, Prepared& prepared) {
  Key key("wide instances");
  key.add(scene.geometry.revision()).add(geometry.near_plane);
  return prepared.get<WideInstances>(key, [&] { return make_wide_instances(geometry, trees); });
}

}  // namespace ps
