#pragma once
#include <utility>
#include <vector>

#include "raytrace/clear/intersector.h"
#include "study/stability/support.h"

namespace ps::stability {

/// In which cells of an octree a primitive is. The program's is in all that it touches; these are written here, to
/// be wrong.
enum class InCells {
  of_its_centre,  ///< in the cell that holds the centre of its box
  of_one_side     ///< in all it touches, but a cell does not own its high sides: what lies on a border is in one cell
};

/// An octree with the box of `like` and cells that are cut `depth` times.
inline Octree<double> octree_with(InCells cells, const TracedGeometry<double>& geometry, const Octree<double>& like,
                                  int depth) {
  const Box<double>& whole = like.nodes[0].box;
  const auto overlaps = [&](std::uint32_t index, const Box<double>& cell) {
    const Box<double> box = primitive_box(geometry, geometry.primitives[index]);
    const Vec3d centre = middle_of(box);
    for (int axis = 0; axis < 3; ++axis) {
      const double low = cells == InCells::of_its_centre ? centre[axis] : box.low[axis];
      const double high = cells == InCells::of_its_centre ? centre[axis] : box.high[axis];
      const bool last = cell.high[axis] == whole.high[axis];  // nothing begins there
      if (low > cell.high[axis] || (low == cell.high[axis] && !last) || high < cell.low[axis]) return false;
    }
    return true;
  };
  return build_octree<double>(whole, static_cast<std::uint32_t>(geometry.primitives.size()), {0, depth}, overlaps);
}

/// How a search through the cells is cut short. The program's own search keeps the nearest hit until no cell begins
/// before it; these rules are mistakes made in grid walks (Amanatides and Woo 1987 have the mailbox, and a safe rule).
enum class Shortcut {
  first_hit_wins,  ///< the first cell with a hit ends the search
  reject_beyond,   ///< a hit counts only if it lies inside the cell that found it
  mailbox          ///< likewise, and each primitive is tested once, in the first cell where it is
};

/// Searches an octree cell by cell from near to far, with a short cut.
class ShortSearch {
 public:
  ShortSearch(const Octree<double>& tree, const Intersector<double, Silent>& primitives, std::size_t count)
      : tree_(tree), primitives_(primitives), tested_by_(count, 0) {}

  Hit<double> nearest(const Ray<double>& ray, Shortcut shortcut) {
    ++ray_number_;
    best_ = {};
    shortcut_ = shortcut;
    ray_ = ray;
    slabs_ = SlabRay<double>(ray.origin, ray.direction, 0);
    nearest_child_ = 0;
    for (unsigned axis = 0; axis < 3; ++axis) nearest_child_ |= slabs_.negative[axis] ? 1u << axis : 0u;
    if (slab_test(slabs_, tree_.nodes[0].box, everywhere).hit()) enter(0);
    return best_;
  }

 private:
  /// Whether the search ends here.
  bool enter(std::uint32_t index) {
    const OctreeNode<double>& node = tree_.nodes[index];
    if (node.leaf) return search(node);
    for (const std::uint32_t i : {0u, 1u, 2u, 4u, 3u, 5u, 6u, 7u}) {  // by the number of farther halves
      const std::uint32_t child = node.first + (i ^ nearest_child_);
      if (slab_test(slabs_, tree_.nodes[child].box, everywhere).hit() && enter(child)) return true;
    }
    return false;
  }

  bool search(const OctreeNode<double>& leaf) {
    const double exit = naive_slab_test(slabs_, leaf.box, everywhere).far;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const std::uint32_t primitive = tree_.entries[leaf.first + i];
      const bool tested = std::exchange(tested_by_[primitive], ray_number_) == ray_number_;
      if (shortcut_ == Shortcut::mailbox && tested) continue;
      const Hit<double> hit = primitives_.one(ray_, primitive);
      if (!hit.found() || (shortcut_ != Shortcut::first_hit_wins && !(hit.t <= exit))) continue;
      if (!best_.found() || hit.t < best_.t) best_ = hit;
    }
    return best_.found();
  }

  const Octree<double>& tree_;
  const Intersector<double, Silent>& primitives_;
  std::vector<std::uint32_t> tested_by_;  ///< of each primitive, the number of the last ray that tested it
  std::uint32_t ray_number_ = 0, nearest_child_ = 0;
  Ray<double> ray_;
  SlabRay<double> slabs_;
  Shortcut shortcut_ = Shortcut::first_hit_wins;
  Hit<double> best_;
};

}  // namespace ps::stability
