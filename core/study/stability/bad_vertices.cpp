#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "accel/slab.h"
#include "raytrace/clear/triangle_watertight.h"
#include "study/stability/closed_sphere.h"
#include "study/stability/support.h"

namespace ps::stability::bad_vertices {
namespace {

/// What std::min and std::max return for a NaN depends on which operand it is: the first one. std::fmin and std::fmax
/// return the number, whichever operand it is; they have the new value first here, where std::min fails.
enum class MinForm { new_first, accumulated_first, fmin };

void include(Box<float>& box, const Vec3f& point, MinForm form) {
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

/// 3,200 triangles.
ClosedSphere small_sphere() { return closed_sphere(33, 50, 2, {0, 0, 0}); }

/// Percentages of rays from the centre that leave a sphere with this number of NaN vertices other than through its
/// holes, for each form of the boxes.
struct Escaping {
  double new_first = 0, accumulated_first = 0, fmin = 0;
};

Escaping escaping(std::size_t bad_vertices, const StabilityRun& run) {
  run.check();
  ClosedSphere mesh = small_sphere();
  Random random(run.seed);
  // The first bad one is at a third of the list: what was taken in before it is lost.
  for (std::size_t i = 0; i < bad_vertices; ++i)
    mesh.vertices[mesh.vertices.size() * (3 + i) / 10] = Vec3f(std::numeric_limits<float>::quiet_NaN());
  const HalfTree new_first(mesh, MinForm::new_first), accumulated_first(mesh, MinForm::accumulated_first);
  const HalfTree fmin(mesh, MinForm::fmin);
  Escaping escaped;
  double all = 0;
  const int rays = run.count(50000, 5000);
  for (int i = 0; i < rays; ++i) {
    const Vec3f origin(random.in_cube(0.2)), direction(random.direction());
    const Shear<float> shear(direction);
    const auto meets = [&](std::size_t k) {
      const auto hit = triangle_watertight<float>(origin, shear, mesh.triangle(k), TriangleGuard::none);
      return hit.verdict == TriangleVerdict::inside && hit.t > 0;
    };
    bool met = false;
    for (std::size_t k = 0; k < mesh.triangles.size() && !met; ++k) met = meets(k);
    if (!met) continue;
    ++all;
    const auto lost = [&](const HalfTree& tree) {
      bool found = false;
      tree.for_each(SlabRay<float>(origin, direction, 0), [&](std::uint32_t k) { found = found || meets(k); });
      return found ? 0 : 1;
    };
    escaped.new_first += lost(new_first);
    escaped.accumulated_first += lost(accumulated_first);
    escaped.fmin += lost(fmin);
  }
  return {percent(escaped.new_first, all), percent(escaped.accumulated_first, all), percent(escaped.fmin, all)};
}

void measure_nan(const StabilityRun& run, Rows& rows) {
  for (const std::size_t bad : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
    const Escaping escaped = escaping(bad, run);
    const auto knob = static_cast<double>(bad);
    rows.add(knob, "tree of halves", escaped.new_first, escaped.accumulated_first, "% of rays lost");
    rows.add(knob, "tree of halves, std::fmin(new, accumulated)", std::nan(""), escaped.fmin, "% of rays lost");
  }
}

}  // namespace

extern const StabilityExperiment nan_vertex{
    .key = "nan-vertex",
    .place = {Subject::boxes, 50},
    .title = "A NaN among the vertices",
    .keywords = "NaN, not a number, bad model, BVH",
    .knob = "vertices that are NaN",
    .naive = "std::min(new, accumulated)",
    .robust = "std::min(accumulated, new) or std::fmin, and refuse NaN on loading",
    .explanation = "std::min returns its first operand when either is NaN. With the new value first, one NaN wipes out "
                   "what a box held before, in every box above it.",
    .safe = "No NaN.",
    .window = {0, 0},
    .series = {{.names = "*",
                .title = "rays that hit nothing any more",
                .unit = "%",
                .cases = {{0, "no NaN"}, {1, "one NaN"}, {3, "three NaN"}}}},
    .add_rows = measure_nan};

}  // namespace ps::stability::bad_vertices
