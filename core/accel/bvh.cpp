#include "accel/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include "accel/binned_split.h"
#include "base/check.h"
#include "base/stop.h"

namespace ps {
namespace {

constexpr int most_shared_levels = 32;  // deeper ranges are one worker's job, too: it keeps to the depth

/// The share of `count` primitives that one step of a parallel pass takes, and the most that are one worker's job. By
/// the count alone: the tree must not depend on the number of threads.
std::uint32_t job_size(std::uint32_t count) { return std::clamp(count / 8, 1u << 10, 1u << 15); }

/// A range of references that will become a node.
template <class Real>
struct Range {
  std::uint32_t node = 0;
  std::uint32_t begin = 0, end = 0;
  int depth = 0;
  Extent<Real> boxes, centroids;  ///< of what it holds; centroids times 2
  std::uint32_t count() const { return end - begin; }
};

/// The part of a large range that one step of a parallel pass takes.
template <class Real>
struct Chunk {
  std::size_t range = 0;
  std::uint32_t begin = 0, end = 0;
  BinSet<Real> bins;
  std::uint32_t left = 0, right = 0;  ///< where its share of the two sides goes
  std::array<Extent<Real>, 2> centroids;
};

template <class Real>
class BvhBuilder {
 public:
  BvhBuilder(std::span<const Box<Real>> boxes, const BvhOptions& options)
      : boxes_(boxes), group_(options.group), options_{options.threads, WorkerPriority::normal},
        job_size_(job_size(static_cast<std::uint32_t>(boxes.size()))) {
    PS_ASSERT(std::has_single_bit(group_), "groups of primitives are cut by shifts");
  }

  Bvh<Real> build() {
    if (boxes_.empty()) return {};
    const auto count = static_cast<std::uint32_t>(boxes_.size());
    bvh_.order.resize(count);
    bvh_.nodes.emplace_back();
    for (auto& references : references_) references.reset(new PrimitiveReference<Real>[count]);
    Range<Real> root = reference_all();
    std::vector<Range<Real>> large{root};
    for (int side = 0; !large.empty(); side = 1 - side) large = split_large(large, side);
    build_subtrees();
    bvh_.reach = bvh_.nodes[0].box.reach();
    return std::move(bvh_);
  }

 private:
  struct Subtree {
    Range<Real> range;
    int side = 0;  ///< which of the two arrays holds its references
    std::vector<BvhNode<Real>> nodes;
  };

  template <class Body>
  void in_parallel(std::size_t count, Body&& body) {
    Progress progress;
    parallel_for(static_cast<int>(count), options_, progress,
                 [&](int index, int) { body(static_cast<std::size_t>(index)); });
  }

  Range<Real> reference_all() {
    const auto count = static_cast<std::uint32_t>(boxes_.size());
    std::vector<std::array<Extent<Real>, 2>> parts((count + job_size_ - 1) / job_size_);
    in_parallel(parts.size(), [&](std::size_t part) {
      const std::uint32_t begin = static_cast<std::uint32_t>(part) * job_size_;
      const std::uint32_t end = std::min(count, begin + job_size_);
      for (std::uint32_t i = begin; i < end; ++i) {
        const PrimitiveReference<Real> reference(boxes_[i], i);
        references_[0][i] = reference;
        parts[part][0].include(reference);
        Lanes4<Real> centroid;
        reference.centroid(centroid);
        parts[part][1].include(centroid);
      }
    });
    Range<Real> root{0, 0, count, 0, {}, {}};
    for (const auto& part : parts) {
      root.boxes.include(part[0]);
      root.centroids.include(part[1]);
    }
    return root;
  }

  bool is_one_job(const Range<Real>& range) const {
    return range.count() <= job_size_ || range.depth >= most_shared_levels;
  }

  /// Splits every range with the help of all threads, moving its references from one array to the other. Returns the
  /// children that are still large; the rest wait in subtrees_. The tree does not depend on the number of threads:
  /// unions and counts come out the same in any grouping, and the two sides keep their order.
  std::vector<Range<Real>> split_large(const std::vector<Range<Real>>& ranges, int side) {
    std::vector<Range<Real>> large;
    std::vector<Chunk<Real>> chunks;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (is_one_job(ranges[i])) {
        subtrees_.push_back({ranges[i], side, {}});
        continue;
      }
      for (std::uint32_t begin = ranges[i].begin; begin < ranges[i].end; begin += job_size_)
        chunks.push_back({i, begin, std::min(ranges[i].end, begin + job_size_), BinSet<Real>(), 0, 0, {}});
    }
    const PrimitiveReference<Real>* const from = references_[static_cast<std::size_t>(side)].get();
    PrimitiveReference<Real>* const to = references_[static_cast<std::size_t>(1 - side)].get();
    in_parallel(chunks.size(), [&](std::size_t i) {
      Chunk<Real>& chunk = chunks[i];
      chunk.bins.add(std::span(from + chunk.begin, from + chunk.end), ranges[chunk.range].centroids);
    });
    const std::vector<BvhSplit<Real>> splits = choose_splits(ranges, chunks);
    in_parallel(chunks.size(), [&](std::size_t i) {
      Chunk<Real>& chunk = chunks[i];
      const BvhSplit<Real>& split = splits[chunk.range];
      move_to_sides(std::span(from + chunk.begin, from + chunk.end), split, to, {chunk.left, chunk.right},
                    chunk.centroids);
    });
    for (std::size_t i = 0, c = 0; i < ranges.size(); ++i) {
      if (is_one_job(ranges[i])) continue;
      std::array<Extent<Real>, 2> centroids;
      for (; c < chunks.size() && chunks[c].range == i; ++c)
        for (std::size_t k = 0; k < 2; ++k) centroids[k].include(chunks[c].centroids[k]);
      if (splits[i].axis < 0) {
        subtrees_.push_back({ranges[i], 1 - side, {}});
        continue;
      }
      for (const Range<Real>& child : children(bvh_.nodes, ranges[i], splits[i], centroids)) large.push_back(child);
    }
    return large;
  }

  /// Appends each of `from` to its side, which begins at `next` in `to`, and adds its centroid to that side's. Without
  /// a branch, which would be guessed wrongly every other time: a point of NaN changes no extent.
  static void move_to_sides(std::span<const PrimitiveReference<Real>> from, const BvhSplit<Real>& split,
                            PrimitiveReference<Real>* to, std::array<std::uint32_t, 2> next,
                            std::array<Extent<Real>, 2>& centroids) {
    using Index = typename FourLanes<Real>::Index;
    Extent<Real> left = centroids[0], right = centroids[1];
    for (const PrimitiveReference<Real>& reference : from) {
      const int goes = split.axis < 0 || split.is_left(reference) ? 0 : 1;
      to[next[static_cast<std::size_t>(goes)]++] = reference;
      const Index to_right = Index{} - goes;
      Lanes4<Real> centroid;
      reference.centroid(centroid);
      left.include(reinterpret_cast<Lanes4<Real>>(reinterpret_cast<Index>(centroid) | to_right));
      right.include(reinterpret_cast<Lanes4<Real>>(reinterpret_cast<Index>(centroid) | ~to_right));
    }
    centroids = {left, right};
  }

  std::vector<BvhSplit<Real>> choose_splits(const std::vector<Range<Real>>& ranges,
                                            std::vector<Chunk<Real>>& chunks) const {
    std::vector<BvhSplit<Real>> splits(ranges.size());
    for (std::size_t first = 0, last = 0; first < chunks.size(); first = last) {
      const Range<Real>& range = ranges[chunks[first].range];
      BinSet<Real> bins = chunks[first].bins;
      for (last = first + 1; last < chunks.size() && chunks[last].range == chunks[first].range; ++last)
        bins.add(chunks[last].bins);
      const BvhSplit<Real> split = bins.best_split(range.count(), range.boxes, range.centroids, group_);
      std::uint32_t left = range.begin, right = range.begin + split.left_count;
      for (std::size_t i = first; i < last; ++i) {
        chunks[i].left = left;
        chunks[i].right = right;
        const std::uint32_t count = chunks[i].end - chunks[i].begin;
        const std::uint32_t goes_left = split.axis < 0 ? count : chunks[i].bins.left_of(split);
        left += goes_left;
        right += count - goes_left;
      }
      splits[chunks[first].range] = split;
    }
    return splits;
  }

  /// Makes an inner node of range.node, whose two children become the last nodes.
  static std::array<Range<Real>, 2> children(std::vector<BvhNode<Real>>& nodes, const Range<Real>& range,
                                             const BvhSplit<Real>& split,
                                             const std::array<Extent<Real>, 2>& centroids) {
    const auto first = static_cast<std::uint32_t>(nodes.size());
    nodes[range.node] = {range.boxes.box(), first, 0};
    nodes.resize(nodes.size() + 2);
    const std::uint32_t middle = range.begin + split.left_count;
    return {Range<Real>{first, range.begin, middle, range.depth + 1, split.left, centroids[0]},
            Range<Real>{first + 1, middle, range.end, range.depth + 1, split.right, centroids[1]}};
  }

  /// Each worker builds whole subtrees; then they are put behind each other.
  void build_subtrees() {
    in_parallel(subtrees_.size(), [&](std::size_t i) {
      Subtree& subtree = subtrees_[i];
      subtree.nodes.reserve(subtree.range.count());
      subtree.nodes.emplace_back();
      Range<Real> range = subtree.range;
      range.node = 0;
      fill(subtree, range, subtree.side);
    });
    std::vector<std::uint32_t> shift;
    std::size_t size = bvh_.nodes.size();
    for (const Subtree& subtree : subtrees_) {
      shift.push_back(static_cast<std::uint32_t>(size) - 1);  // its root has a place already
      size += subtree.nodes.size() - 1;
    }
    bvh_.nodes.resize(size);
    in_parallel(subtrees_.size(), [&](std::size_t i) {
      Subtree& subtree = subtrees_[i];
      for (std::size_t k = 0; k < subtree.nodes.size(); ++k) {
        BvhNode<Real> node = subtree.nodes[k];
        if (node.count == 0) node.first += shift[i];
        bvh_.nodes[k == 0 ? subtree.range.node : shift[i] + k] = node;
      }
      std::vector<BvhNode<Real>>().swap(subtree.nodes);
    });
  }

  /// `side`: which array holds the range's references.
  void fill(Subtree& subtree, const Range<Real>& range, int side) {
    if (range.count() > 512) check_stop();
    const PrimitiveReference<Real>* const references = references_[static_cast<std::size_t>(side)].get();
    const std::span own(references + range.begin, references + range.end);
    const bool whole = range.count() == boxes_.size();
    const std::uint32_t leaf = whole ? bvh_no_tree : group_;
    BvhSplit<Real> split;
    if (range.count() > leaf && range.depth < bvh_max_depth - 1) {
      BinSet<Real> bins(bins_for(range.count()));
      bins.add(own, range.centroids);
      split = bins.best_split(range.count(), range.boxes, range.centroids, group_);
    }
    if (split.axis < 0 && range.count() > 4 * leaf && range.depth < bvh_max_depth - 1 &&
        !std::isfinite(range.boxes.half_area())) {
      for (const Range<Real>& child : halves(subtree, range, references)) fill(subtree, child, side);
      return;
    }
    if (split.axis < 0) {
      subtree.nodes[range.node] = {range.boxes.box(), range.begin, range.count()};
      for (std::uint32_t i = range.begin; i < range.end; ++i) bvh_.order[i] = references[i].primitive();
      return;
    }
    std::array<Extent<Real>, 2> centroids;
    move_to_sides(own, split, references_[static_cast<std::size_t>(1 - side)].get(),
                  {range.begin, range.begin + split.left_count}, centroids);
    for (const Range<Real>& child : children(subtree.nodes, range, split, centroids)) fill(subtree, child, 1 - side);
  }

  /// Where areas overflow, no cut costs less than another. Neighbours in a mesh mostly are together in its list, so
  /// that half of the list is better than a leaf of thousands.
  std::array<Range<Real>, 2> halves(Subtree& subtree, const Range<Real>& range,
                                    const PrimitiveReference<Real>* references) {
    BvhSplit<Real> split;
    split.left_count = range.count() / 2;
    std::array<Extent<Real>, 2> centroids;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const bool left = i - range.begin < split.left_count;
      (left ? split.left : split.right).include(references[i]);
      Lanes4<Real> centroid;
      references[i].centroid(centroid);
      centroids[left ? 0 : 1].include(centroid);
    }
    return children(subtree.nodes, range, split, centroids);
  }

  std::span<const Box<Real>> boxes_;
  std::uint32_t group_;
  ParallelOptions options_;
  std::uint32_t job_size_;
  std::array<std::unique_ptr<PrimitiveReference<Real>[]>, 2> references_;
  std::vector<Subtree> subtrees_;
  Bvh<Real> bvh_;
};

}  // namespace

template <class Real>
Bvh<Real> build_bvh(std::span<const Box<Real>> boxes, const BvhOptions& options) {
  return BvhBuilder<Real>(boxes, options).build();
}

template Bvh<float> build_bvh(std::span<const Box<float>>, const BvhOptions&);
template Bvh<double> build_bvh(std::span<const Box<double>>, const BvhOptions&);

}  // namespace ps
