#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "accel/box.h"
#include "accel/four_lanes.h"

namespace ps {

/// A box in four lanes; the last lane is not used. Without a value at first.
template <class Real>
struct Bounds {
  Lanes4<Real> low, high;

  void include(const Bounds& other) {
    low = other.low < low ? other.low : low;
    high = other.high > high ? other.high : high;
  }
  void include(const Lanes4<Real>& point) {
    low = point < low ? point : low;
    high = point > high ? point : high;
  }
  Box<Real> box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
  double half_area() const {
    const Lanes4<Real> size = high - low;
    return static_cast<double>(size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  }
};

/// Empty at first.
template <class Real>
struct Extent : Bounds<Real> {
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Extent() : Bounds<Real>{{infinity, infinity, infinity, infinity}, {-infinity, -infinity, -infinity, -infinity}} {}
};

/// A primitive while the tree is built: its box, with its number in the lane that is free. Without a value at first.
template <class Real>
struct PrimitiveReference : Bounds<Real> {
  PrimitiveReference() = default;
  PrimitiveReference(const Box<Real>& box, std::uint32_t primitive)
      : Bounds<Real>{{box.low.x, box.low.y, box.low.z, 0},
                     {box.high.x, box.high.y, box.high.z, std::bit_cast<Real>(normal ^ primitive)}} {}
  std::uint32_t primitive() const {
    return static_cast<std::uint32_t>(std::bit_cast<Bits>(Real{this->high[3]}) ^ normal);
  }
  /// Twice the centroid. Not returned by value: the calling convention of wide vectors varies.
  void centroid(Lanes4<Real>& result) const { result = this->low + this->high; }

 private:
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  /// The bits of 2: a small whole number's own bits are a denormal, with which many processors take ten times as long.
  static constexpr Bits normal = Bits{1} << (8 * sizeof(Real) - 2);
};

inline constexpr int most_bins = 16;
/// Small nodes are split about as well with fewer bins.
inline int bins_for(std::uint32_t count) { return count <= 24 ? 8 : most_bins; }

/// Into which bin a centroid falls on each axis. On an axis without extent all fall into bin 0.
template <class Real>
struct Binning {
  Lanes4<Real> low{}, scale{}, last{};
  Binning() = default;
  Binning(const Extent<Real>& centroids, int bins) : low(centroids.low) {
    for (int axis = 0; axis < 4; ++axis) {
      const Real size = centroids.high[axis] - centroids.low[axis];
      const Real per_unit = static_cast<Real>(bins) / size;
      const bool usable = axis < 3 && size > 0 && per_unit < std::numeric_limits<Real>::infinity();
      scale[axis] = usable ? per_unit : 0;
      last[axis] = static_cast<Real>(bins - 1);
    }
  }
  void find(const Lanes4<Real>& centroid, typename FourLanes<Real>::Index& bins) const {
    const Lanes4<Real> share = (centroid - low) * scale;
    bins = __builtin_convertvector(share < last ? share : last, typename FourLanes<Real>::Index);
  }
};

/// Where a node is cut: references whose bin on `axis` is below `bin` go left.
template <class Real>
struct BvhSplit {
  int axis = -1;  ///< -1: it stays whole
  int bin = 0;
  std::uint32_t left_count = 0;
  Extent<Real> left, right;
  Binning<Real> binning;
  /// As binning.find() says, of the one axis.
  bool is_left(const PrimitiveReference<Real>& reference) const {
    const Real share = (reference.low[axis] + reference.high[axis] - binning.low[axis]) * binning.scale[axis];
    const Real last = binning.last[axis];
    return static_cast<int>(share < last ? share : last) < bin;
  }
};

inline constexpr double bvh_traversal_cost = 0.5;  ///< of a node, in tests of a group of primitives

/// Boxes and counts of the references by bin, for all three axes at once (Wald 2007).
template <class Real>
class BinSet {
 public:
  explicit BinSet(int bins = most_bins) : bins_(bins) {
    for (std::size_t bin = 0; bin < count_of_bins(); ++bin) {
      boxes_[bin].fill(Extent<Real>());
      counts_[bin] = AxisCounts{};
    }
  }

  void add(std::span<const PrimitiveReference<Real>> references, const Extent<Real>& centroids) {
    binning_ = Binning<Real>(centroids, bins_);
    constexpr std::size_t many = 64;
    if (references.size() < many) return put_each(references);
    // Neighbours often fall into the same bin, and would wait for each other there.
    BinSet other(bins_);
    other.binning_ = binning_;
    const std::size_t half = references.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      put(references[i]);
      other.put(references[half + i]);
    }
    put_each(references.subspan(2 * half));
    add(other);
  }
  void add(const BinSet& other) {
    for (std::size_t bin = 0; bin < count_of_bins(); ++bin) {
      for (std::size_t axis = 0; axis < 3; ++axis) boxes_[bin][axis].include(other.boxes_[bin][axis]);
      counts_[bin] += other.counts_[bin];
    }
  }

  /// The cut that costs least by the surface-area heuristic, primitives counting in groups of `group` (a power of two)
  /// as they are tested. Large nodes are always cut if they can be; one of moderate size may stay whole. The three axes
  /// are in lanes. A cut with an empty side costs NaN, infinity times no group, which is never less.
  BvhSplit<Real> best_split(std::uint32_t count, const Extent<Real>& box, const Extent<Real>& centroids,
                            std::uint32_t group) const {
    const double node_cost = bvh_traversal_cost * box.half_area();
    const std::uint32_t groups = (count + group - 1) / group;
    const double uncut = count > 4 * group ? std::numeric_limits<double>::infinity() : groups * box.half_area();
    std::array<AxisCosts, most_bins> costs;
    Sides sides;
    for (std::size_t bin = count_of_bins() - 1; bin > 0; --bin) {
      sides.include(boxes_[bin], counts_[bin]);
      sides.cost(group, costs[bin]);
    }
    sides = Sides();
    for (std::size_t bin = 1; bin < count_of_bins(); ++bin) {
      sides.include(boxes_[bin - 1], counts_[bin - 1]);
      AxisCosts left;
      sides.cost(group, left);
      costs[bin] = node_cost + left + costs[bin];
    }
    double best_cost = uncut;
    int best_axis = -1, best_bin = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centroids.high[axis] > centroids.low[axis])) continue;
      for (int bin = 1; bin < bins_; ++bin) {
        const double cost = costs[static_cast<std::size_t>(bin)][axis];
        if (!(cost < best_cost)) continue;
        best_cost = cost;
        best_axis = axis;
        best_bin = bin;
      }
    }
    return best_axis < 0 ? BvhSplit<Real>() : describe(best_axis, best_bin);
  }

  /// How many of these references go left.
  std::uint32_t left_of(const BvhSplit<Real>& split) const {
    std::uint32_t sum = 0;
    for (int i = 0; i < split.bin; ++i)
      sum += static_cast<std::uint32_t>(counts_[static_cast<std::size_t>(i)][split.axis]);
    return sum;
  }

 private:
  // One of each for an axis; the fourth lane is not used.
  using AxisBounds = std::array<Bounds<Real>, 3>;
  using AxisCounts = FourLanes<float>::Index;
  using AxisCosts = Lanes4<double>;

  /// One side of a cut on each axis.
  struct Sides {
    std::array<Extent<Real>, 3> boxes;
    AxisCounts counts{};

    void include(const AxisBounds& bounds, const AxisCounts& more) {
#pragma GCC unroll 3
      for (std::size_t axis = 0; axis < 3; ++axis) boxes[axis].include(bounds[axis]);
      counts += more;
    }
    /// Half the surface area of each axis's box times the groups of its primitives.
    void cost(std::uint32_t group, AxisCosts& result) const {
      const Lanes4<Real> a = boxes[0].high - boxes[0].low, b = boxes[1].high - boxes[1].low,
                         c = boxes[2].high - boxes[2].low;
      const Lanes4<Real> ab = __builtin_shufflevector(a, b, 0, 4, 1, 5),
                         ab_z = __builtin_shufflevector(a, b, 2, 6, 3, 7);
      const Lanes4<Real> x = __builtin_shufflevector(ab, c, 0, 1, 4, 4), y = __builtin_shufflevector(ab, c, 2, 3, 5, 5),
                         z = __builtin_shufflevector(ab_z, c, 0, 1, 6, 6);
      const AxisCounts groups_of = (counts + (static_cast<int>(group) - 1)) >> std::countr_zero(group);
      result =
          __builtin_convertvector(x * y + y * z + z * x, AxisCosts) * __builtin_convertvector(groups_of, AxisCosts);
    }
  };

  std::size_t count_of_bins() const { return static_cast<std::size_t>(bins_); }
  void put_each(std::span<const PrimitiveReference<Real>> references) {
    for (const PrimitiveReference<Real>& reference : references) put(reference);
  }
  void put(const PrimitiveReference<Real>& reference) {
    Lanes4<Real> centroid;
    typename FourLanes<Real>::Index index;
    reference.centroid(centroid);
    binning_.find(centroid, index);
#pragma GCC unroll 3
    for (int axis = 0; axis < 3; ++axis) {
      const auto bin = static_cast<std::size_t>(index[axis]);
      boxes_[bin][static_cast<std::size_t>(axis)].include(reference);
      ++counts_[bin][axis];
    }
  }

  BvhSplit<Real> describe(int axis, int bin) const {
    BvhSplit<Real> split;
    split.axis = axis;
    split.bin = bin;
    split.binning = binning_;
    split.left_count = left_of(split);
    for (int i = 0; i < bins_; ++i)
      (i < bin ? split.left : split.right).include(boxes_[static_cast<std::size_t>(i)][static_cast<std::size_t>(axis)]);
    return split;
  }

  int bins_;
  std::array<AxisBounds, most_bins> boxes_;  ///< of the bins in use, as counts_
  std::array<AxisCounts, most_bins> counts_;
  Binning<Real> binning_;
};

}  // namespace ps
