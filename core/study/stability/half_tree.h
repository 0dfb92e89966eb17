#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "accel/slab.h"
#include "study/stability/closed_sphere.h"

namespace ps::stability {

/// What std::min and std::max return for a NaN depends on which operand it is: the first one. std::fmin and std::fmax
/// return the number, whichever operand it is; they have the new value first here, where std::min fails.
enum class MinForm { new_first, accumulated_first, fmin };

inline void include(Box<float>& box, const Vec3f& point, MinForm form) {
  for (int axis = 0; axis < 3; ++axis) switch (form) {
    case MinForm::new_first:
      box.low[axis] = std::min(point[axis], box.low[axis]);
      box.high[axis] = std::max(point[axis], box.high[axis]);
      break;
    case MinForm::accumulated_first:
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
      break;
    case MinForm::fmin:
      box.low[axis] = std::fmin(point[axis], box.low[axis]);
      box.high[axis] = std::fmax(point[axis], box.high[axis]);
      break;
    }
}

/// The simplest tree of boxes: triangles halved along each axis in turn, down to two a leaf; a box is taken around all
/// vertices below it, one after another.
class HalfTree {
 public:
  HalfTree(const ClosedSphere& mesh, MinForm form) : mesh_(mesh), form_(form), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(2 * order_.size());
    build(0, order_.size(), 0);
  }

  /// Calls visit(triangle) for each triangle in a leaf whose boxes the ray meets.
  template <class Visit>
  void for_each(const SlabRay<float>& ray, Visit&& visit) const {
    std::vector<std::size_t> waiting{0};
    while (!waiting.empty()) {
      const std::size_t index = waiting.back();
      waiting.pop_back();
      const Node& node = nodes_[index];
      if (!slab_test(ray, node.box, std::numeric_limits<float>::infinity()).hit()) continue;
      if (node.right == 0) {
        for (std::size_t i = node.first; i < node.first + node.count; ++i) visit(order_[i]);
      } else {
        waiting.push_back(node.right);
        waiting.push_back(index + 1);
      }
    }
  }

 private:
  struct Node {
    Box<float> box;
    std::size_t first = 0, count = 0;  // of a leaf's triangles in order_
    std::size_t right = 0;             // the left child follows its parent; 0 = a leaf
  };

  void build(std::size_t first, std::size_t count, int axis) {
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    for (std::size_t i = first; i < first + count; ++i)
      for (const std::uint32_t corner : mesh_.triangles[order_[i]])
        include(nodes_[index].box, mesh_.vertices[corner], form_);
    if (count <= most_in_leaf) {
      nodes_[index].first = first;
      nodes_[index].count = count;
      return;
    }
    const auto centre = [&](std::uint32_t i) {  // NaN sorts as 0
      float sum = 0;
      for (const std::uint32_t corner : mesh_.triangles[i]) sum += mesh_.vertices[corner][axis];
      return std::isfinite(sum) ? sum : 0.0f;
    };
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto half = static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
                     [&](std::uint32_t a, std::uint32_t b) { return centre(a) < centre(b); });
    build(first, count / 2, (axis + 1) % 3);
    nodes_[index].right = nodes_.size();
    build(first + count / 2, count - count / 2, (axis + 1) % 3);
  }

  static constexpr std::size_t most_in_leaf = 2;
  const ClosedSphere& mesh_;
  MinForm form_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace ps::stability
