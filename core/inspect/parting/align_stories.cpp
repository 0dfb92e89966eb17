#include "inspect/parting/align_stories.h"

#include <algorithm>
#include <cstdint>

#include "inspect/describe.h"
#include "inspect/parting/align_parts.h"
#include "options/renderer_kind.h"
#include "record/event_fields.h"
#include "textbook/listing_events.h"

namespace ps {
namespace {

using parting::EventTree;

/// Above this many pairs of siblings they are matched greedily: a table of all pairs would take too long to fill.
constexpr std::size_t most_pairs = 4'000'000;

/// A listing takes the steps of one of the other renderers.
Renderer steps_of(const PixelStory& story) {
  return story.listing ? stepped_like(story.listing->listing) : story.renderer;
}

class Aligner {
 public:
  Aligner(const EventTree& a, const EventTree& b, const Scene& scene) : a_(a), b_(b), scene_(scene) {}

  void pair_up(int above_a, int above_b, int depth) {
    const auto& a = a_.below(above_a);
    const auto& b = b_.below(above_b);
    std::size_t i = 0, j = 0;
    for (const auto& [partner_a, partner_b] : parting::common_sequence(keys(a_, a), keys(b_, b))) {
      while (i < partner_a) only_a(a[i++], depth);
      while (j < partner_b) only_b(b[j++], depth);
      const int event_a = a[i++], event_b = b[j++];
      rows.push_back({event_a, event_b, depth, text(a_, event_a) == text(b_, event_b)});
      pair_up(event_a, event_b, depth + 1);
    }
    while (i < a.size()) only_a(a[i++], depth);
    while (j < b.size()) only_b(b[j++], depth);
  }

  std::vector<AlignedRow> rows;

 private:
  static std::vector<std::string> keys(const EventTree& tree, const std::vector<int>& events) {
    std::vector<std::string> keys;
    keys.reserve(events.size());
    for (const int event : events) keys.push_back(event_subject(tree.event(event).data));
    return keys;
  }

  std::string text(const EventTree& tree, int event) const { return describe(tree.event(event), scene_); }

  void only_a(int event, int depth) {
    rows.push_back({event, -1, depth, false});
    for (const int child : a_.below(event)) only_a(child, depth + 1);
  }
  void only_b(int event, int depth) {
    rows.push_back({-1, event, depth, false});
    for (const int child : b_.below(event)) only_b(child, depth + 1);
  }

  const EventTree& a_;
  const EventTree& b_;
  const Scene& scene_;
};

}  // namespace

std::vector<AlignedRow> align_stories(const PixelStory& a, const PixelStory& b, const Scene& scene) {
  const EventTree tree_a(a), tree_b(b);
  const Renderer way_a = steps_of(a), way_b = steps_of(b);
  if (sends_rays(way_a) != sends_rays(way_b)) {
    const bool ray_first = sends_rays(way_a);
    auto rows = parting::align_ray_and_fragment(ray_first ? tree_a : tree_b, ray_first ? tree_b : tree_a, scene);
    if (!ray_first)
      for (AlignedRow& row : rows) std::swap(row.a, row.b);
    if (!rows.empty()) return rows;
  }
  Aligner aligner(tree_a, tree_b, scene);
  aligner.pair_up(-1, -1, 0);
  return std::move(aligner.rows);
}

namespace parting {

EventTree::EventTree(const PixelStory& story) : story_(story), children_(story.events.size() + 1) {
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const int parent = story.events[i].parent;
    children_[parent < 0 ? story.events.size() : static_cast<std::size_t>(parent)].push_back(static_cast<int>(i));
  }
}

std::vector<std::pair<std::size_t, std::size_t>> common_sequence(const std::vector<std::string>& a,
                                                                 const std::vector<std::string>& b) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (a.size() * b.size() > most_pairs) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size(); ++i)
      if (a[i] == b[j]) pairs.push_back({i, j++});
    return pairs;
  }
  const std::size_t width = b.size() + 1;
  std::vector<std::uint32_t> longest((a.size() + 1) * width, 0);  // of the sequences from (i, j) on
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      longest[i * width + j] = a[i] == b[j] ? longest[(i + 1) * width + j + 1] + 1
                                            : std::max(longest[(i + 1) * width + j], longest[i * width + j + 1]);
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j])
      pairs.push_back({i++, j++});
    else if (longest[(i + 1) * width + j] >= longest[i * width + j + 1])
      ++i;
    else
      ++j;
  }
  return pairs;
}

}  // namespace parting
}  // namespace ps
