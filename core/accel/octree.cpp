#include "accel/octree.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/stop.h"

namespace ps {
namespace {

/// How many entries the leaves may have together. Ordinary meshes stay far below it: what is there for the thin or
/// nearly coincident triangles that no depth separates.
std::uint64_t most_octree_entries(std::uint64_t primitives) {
  constexpr std::uint64_t small = 100'000;
  return std::max(64 * std::min(primitives, small) + 4096, 8 * primitives);
}

/// Primitives by the place where they lie: those in one place go everywhere together, and count as one.
class Places {
 public:
  Places(std::uint32_t primitives, std::span<const std::uint32_t> coincident) : coincident_(coincident) {
    for (std::uint32_t i = 0; i < primitives; ++i)
      if (coincident.empty() || coincident[i] == i) all_.push_back(i);
    if (all_.size() == primitives) return;
    next_.assign(primitives, end);
    members_.assign(primitives, 1);
    for (std::uint32_t i = primitives; i-- > 0;) {
      const std::uint32_t first = coincident[i];
      if (first == i) continue;
      next_[i] = next_[first];
      next_[first] = i;
      ++members_[first];
    }
  }
  /// The first primitive of each place.
  const std::vector<std::uint32_t>& all() const { return all_; }
  std::uint64_t primitives_of(const std::vector<std::uint32_t>& places) const {
    if (members_.empty()) return places.size();
    std::uint64_t sum = 0;
    for (const std::uint32_t place : places) sum += members_[place];
    return sum;
  }
  /// Appends all primitives of these places, the lowest first.
  void append(const std::vector<std::uint32_t>& places, std::vector<std::uint32_t>& entries) const {
    if (members_.empty()) {
      entries.insert(entries.end(), places.begin(), places.end());
      return;
    }
    const auto before = static_cast<std::ptrdiff_t>(entries.size());
    for (const std::uint32_t place : places)
      for (std::uint32_t i = place; i != end; i = next_[i]) entries.push_back(i);
    std::sort(entries.begin() + before, entries.end());
  }

 private:
  static constexpr std::uint32_t end = 0xffffffffu;
  std::span<const std::uint32_t> coincident_;
  std::vector<std::uint32_t> all_;
  std::vector<std::uint32_t> next_, members_;  ///< empty: each primitive has a place of its own
};

/// How cells share the entries: first come, first served, until there are none left; or each cell its share.
enum class Sharing { first_come, by_count };

template <class Real>
class OctreeBuilder {
 public:
  using Overlaps = std::function<bool(std::uint32_t, const Box<Real>&)>;
  OctreeBuilder(const OctreeOptions& options, const Places& places, const Overlaps& overlaps, Sharing sharing)
      : options_(options), places_(places), overlaps_(overlaps), sharing_(sharing) {}

  /// nullopt where first come, first served does not leave enough for everyone.
  std::optional<Octree<Real>> build(const Box<Real>& box) {
    octree_.nodes.emplace_back();
    octree_.nodes[0].box = box;
    most_entries_ = most_octree_entries(places_.primitives_of(places_.all()));
    if (!fill(0, places_.all(), 0, static_cast<double>(most_entries_))) return {};
    return std::move(octree_);
  }

 private:
  /// False: the entries are used up. `share`: how many of them the cell may use.
  bool fill(std::uint32_t index, const std::vector<std::uint32_t>& inside, int depth, double share) {
    check_stop();
    const Box<Real> box = octree_.nodes[index].box;
    const Vec3<Real> middle = middle_of(box);
    if (inside.size() <= options_.leaf || depth >= std::min(options_.depth, octree_max_depth))
      return make_leaf(index, inside);
    std::array<std::vector<std::uint32_t>, 8> parts;
    std::array<Box<Real>, 8> cells;
    std::array<double, 8> counts{};
    double together = 0;
    bool useful = false;
    for (std::size_t child = 0; child < 8; ++child) {
      cells[child] = box;
      for (int axis = 0; axis < 3; ++axis)
        (((child >> axis) & 1u) != 0 ? cells[child].low : cells[child].high)[axis] = middle[axis];
      for (std::size_t i = 0; i < inside.size(); ++i) {
        if (i % 4096 == 4095) check_stop();
        if (overlaps_(inside[i], cells[child])) parts[child].push_back(inside[i]);
      }
      counts[child] = static_cast<double>(places_.primitives_of(parts[child]));
      together += counts[child];
      useful = useful || parts[child].size() < inside.size();
    }
    if (!useful) return make_leaf(index, inside);  // everything is everywhere: no depth helps
    if (sharing_ == Sharing::by_count && together > share) return make_leaf(index, inside);
    const auto first = static_cast<std::uint32_t>(octree_.nodes.size());
    octree_.nodes[index].first = first;
    octree_.nodes[index].leaf = false;
    for (std::size_t child = 0; child < 8; ++child)
      if (!parts[child].empty()) octree_.nodes[index].filled |= static_cast<std::uint8_t>(1u << child);
    octree_.nodes.resize(octree_.nodes.size() + 8);
    for (std::uint32_t child = 0; child < 8; ++child) {
      octree_.nodes[first + child].box = cells[child];
      if (!fill(first + child, parts[child], depth + 1, share * counts[child] / together)) return false;
      std::vector<std::uint32_t>().swap(parts[child]);
    }
    return true;
  }

  bool make_leaf(std::uint32_t index, const std::vector<std::uint32_t>& inside) {
    const std::size_t before = octree_.entries.size();
    octree_.nodes[index].first = static_cast<std::uint32_t>(before);
    places_.append(inside, octree_.entries);
    octree_.nodes[index].count = static_cast<std::uint32_t>(octree_.entries.size() - before);
    return sharing_ == Sharing::by_count || octree_.entries.size() <= most_entries_;
  }

  OctreeOptions options_;
  const Places& places_;
  const Overlaps& overlaps_;
  Sharing sharing_;
  std::uint64_t most_entries_ = 0;
  Octree<Real> octree_;
};

}  // namespace

template <class Real>
Octree<Real> build_octree(const Box<Real>& box, std::uint32_t primitives, const OctreeOptions& options,
                          const std::function<bool(std::uint32_t, const Box<Real>&)>& overlaps,
                          std::span<const std::uint32_t> coincident) {
  if (primitives == 0) return {};
  const Places places(primitives, coincident);
  if (auto octree = OctreeBuilder<Real>(options, places, overlaps, Sharing::first_come).build(box))
    return std::move(*octree);
  return *OctreeBuilder<Real>(options, places, overlaps, Sharing::by_count).build(box);
}

template Octree<float> build_octree(const Box<float>&, std::uint32_t, const OctreeOptions&,
                                    const std::function<bool(std::uint32_t, const Box<float>&)>&,
                                    std::span<const std::uint32_t>);
template Octree<double> build_octree(const Box<double>&, std::uint32_t, const OctreeOptions&,
                                     const std::function<bool(std::uint32_t, const Box<double>&)>&,
                                     std::span<const std::uint32_t>);

}  // namespace ps
