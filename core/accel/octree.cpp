#include "accel/octree.h"

#include <numeric>

namespace ps {
namespace {

template <class Real>
class OctreeBuilder {
 public:
  using Overlaps = std::function<bool(std::uint32_t, const Box<Real>&)>;
  OctreeBuilder(const OctreeOptions& options, std::uint32_t primitives, const Overlaps& overlaps)
      : options_(options), most_entries_(64ull * primitives + 4096), overlaps_(overlaps) {}

  Octree<Real> build(const Box<Real>& box, std::uint32_t primitives) {
    if (primitives == 0) return {};
    std::vector<std::uint32_t> all(primitives);
    std::iota(all.begin(), all.end(), 0u);
    octree_.nodes.emplace_back();
    octree_.nodes[0].box = box;
    fill(0, all, 0);
    return std::move(octree_);
  }

 private:
  void fill(std::uint32_t index, const std::vector<std::uint32_t>& inside, int depth) {
    const Box<Real> box = octree_.nodes[index].box;
    const Vec3<Real> middle = middle_of(box);
    const bool full = octree_.entries.size() + inside.size() > most_entries_;
    if (inside.size() <= options_.leaf || depth >= std::min(options_.depth, octree_max_depth) || full)
      return make_leaf(index, inside);
    std::array<std::vector<std::uint32_t>, 8> parts;
    std::array<Box<Real>, 8> cells;
    bool useful = false;
    for (std::size_t child = 0; child < 8; ++child) {
      cells[child] = box;
      for (int axis = 0; axis < 3; ++axis)
        (((child >> axis) & 1u) != 0 ? cells[child].low : cells[child].high)[axis] = middle[axis];
      for (const std::uint32_t primitive : inside)
        if (overlaps_(primitive, cells[child])) parts[child].push_back(primitive);
      useful = useful || parts[child].size() < inside.size();
    }
    if (!useful) return make_leaf(index, inside);  // everything is everywhere: no depth helps
    const auto first = static_cast<std::uint32_t>(octree_.nodes.size());
    octree_.nodes[index].first = first;
    octree_.nodes[index].leaf = false;
    for (std::size_t child = 0; child < 8; ++child)
      if (!parts[child].empty()) octree_.nodes[index].filled |= static_cast<std::uint8_t>(1u << child);
    octree_.nodes.resize(octree_.nodes.size() + 8);
    for (std::uint32_t child = 0; child < 8; ++child) {
      octree_.nodes[first + child].box = cells[child];
      fill(first + child, parts[child], depth + 1);
      std::vector<std::uint32_t>().swap(parts[child]);
    }
  }

  void make_leaf(std::uint32_t index, const std::vector<std::uint32_t>& inside) {
    octree_.nodes[index].first = static_cast<std::uint32_t>(octree_.entries.size());
    octree_.nodes[index].count = static_cast<std::uint32_t>(inside.size());
    octree_.entries.insert(octree_.entries.end(), inside.begin(), inside.end());
  }

  OctreeOptions options_;
  std::size_t most_entries_;  // thin triangles across many cells must not fill the memory
  const Overlaps& overlaps_;
  Octree<Real> octree_;
};

}  // namespace

template <class Real>
Octree<Real> build_octree(const Box<Real>& box, std::uint32_t primitives, const OctreeOptions& options,
                          const std::function<bool(std::uint32_t, const Box<Real>&)>& overlaps) {
  return OctreeBuilder<Real>(options, primitives, overlaps).build(box, primitives);
}

template Octree<float> build_octree(const Box<float>&, std::uint32_t, const OctreeOptions&,
                                    const std::function<bool(std::uint32_t, const Box<float>&)>&);
template Octree<double> build_octree(const Box<double>&, std::uint32_t, const OctreeOptions&,
                                     const std::function<bool(std::uint32_t, const Box<double>&)>&);

}  // namespace ps
