#include "accel/bvh.h"

#include <algorithm>
#include <numeric>

namespace ps {
namespace {

constexpr int bin_count = 16;
constexpr std::uint32_t leaf_size = 4;
constexpr double traversal_cost = 1;  // of a node, in primitive tests

template <class Real>
class Builder {
 public:
  explicit Builder(std::span<const Box<Real>> boxes) : boxes_(boxes) {
    centroids_.reserve(boxes.size());
    for (const Box<Real>& box : boxes) centroids_.push_back(box.low * Real(0.5) + box.high * Real(0.5));
  }

  Bvh<Real> build() {
    bvh_.order.resize(boxes_.size());
    std::iota(bvh_.order.begin(), bvh_.order.end(), 0u);
    if (boxes_.empty()) return std::move(bvh_);
    bvh_.nodes.emplace_back();
    fill(0, 0, static_cast<std::uint32_t>(boxes_.size()), 0);
    bvh_.reach = bvh_.nodes[0].box.reach();
    return std::move(bvh_);
  }

 private:
  struct Bin {
    Box<Real> box;
    std::uint32_t count = 0;
  };
  struct Split {
    int axis = -1;  // -1: none is worth it
    int bin = 0;    // the first bin of the right side
  };

  void fill(std::uint32_t node, std::uint32_t begin, std::uint32_t end, int depth) {
    Box<Real> box, middle;
    for (std::uint32_t i = begin; i < end; ++i) {
      box.include(boxes_[bvh_.order[i]]);
      middle.include(centroids_[bvh_.order[i]]);
    }
    bvh_.nodes[node].box = box;
    const std::uint32_t split = depth < bvh_max_depth - 1 ? partition(begin, end, box, middle) : begin;
    if (split == begin || split == end) {
      bvh_.nodes[node].first = begin;
      bvh_.nodes[node].count = end - begin;
      return;
    }
    const auto children = static_cast<std::uint32_t>(bvh_.nodes.size());
    bvh_.nodes[node].first = children;
    bvh_.nodes.resize(bvh_.nodes.size() + 2);
    fill(children, begin, split, depth + 1);
    fill(children + 1, split, end, depth + 1);
  }

  /// Sorts [begin, end) into two sides and returns where the right one begins; begin = leave it whole.
  std::uint32_t partition(std::uint32_t begin, std::uint32_t end, const Box<Real>& box, const Box<Real>& middle) {
    const std::uint32_t count = end - begin;
    if (count <= (begin == 0 && count == boxes_.size() ? bvh_no_tree : leaf_size)) return begin;
    const Split split = best_split(begin, end, box, middle);
    if (split.axis < 0) return begin;
    const auto first = bvh_.order.begin();
    const auto right = std::partition(first + begin, first + end, [&](std::uint32_t primitive) {
      return bin_of(centroids_[primitive], split.axis, middle) < split.bin;
    });
    return static_cast<std::uint32_t>(right - first);
  }

  static int bin_of(const Vec3<Real>& centroid, int axis, const Box<Real>& middle) {
    const Real share = (centroid[axis] - middle.low[axis]) / (middle.high[axis] - middle.low[axis]);
    return std::clamp(static_cast<int>(share * bin_count), 0, bin_count - 1);
  }

  Split best_split(std::uint32_t begin, std::uint32_t end, const Box<Real>& box, const Box<Real>& middle) const {
    Split best;
    const double area = static_cast<double>(box.half_area());
    const std::uint32_t count = end - begin;
    // Large nodes are always split; a leaf of moderate size may stay whole.
    double best_cost = count > 4 * leaf_size ? std::numeric_limits<double>::infinity() : count * area;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(middle.high[axis] > middle.low[axis])) continue;
      std::array<Bin, bin_count> bins;
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t primitive = bvh_.order[i];
        Bin& bin = bins[static_cast<std::size_t>(bin_of(centroids_[primitive], axis, middle))];
        bin.box.include(boxes_[primitive]);
        ++bin.count;
      }
      std::array<double, bin_count> right_cost{};
      Bin right;
      for (int i = bin_count - 1; i > 0; --i) {
        add(right, bins[static_cast<std::size_t>(i)]);
        right_cost[static_cast<std::size_t>(i)] = cost(right);
      }
      Bin left;
      for (int i = 1; i < bin_count; ++i) {
        add(left, bins[static_cast<std::size_t>(i - 1)]);
        if (left.count == 0 || left.count == count) continue;
        const double total = traversal_cost * area + cost(left) + right_cost[static_cast<std::size_t>(i)];
        if (total < best_cost) {
          best_cost = total;
          best = {axis, i};
        }
      }
    }
    return best;
  }

  static void add(Bin& sum, const Bin& bin) {
    if (bin.count == 0) return;  // an empty box would make the union infinite
    sum.box.include(bin.box);
    sum.count += bin.count;
  }
  static double cost(const Bin& bin) { return static_cast<double>(bin.box.half_area()) * bin.count; }

  std::span<const Box<Real>> boxes_;
  std::vector<Vec3<Real>> centroids_;
  Bvh<Real> bvh_;
};

}  // namespace

template <class Real>
Bvh<Real> build_bvh(std::span<const Box<Real>> boxes) {
  return Builder<Real>(boxes).build();
}

template Bvh<float> build_bvh(std::span<const Box<float>>);
template Bvh<double> build_bvh(std::span<const Box<double>>);

}  // namespace ps
