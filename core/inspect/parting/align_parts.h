#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "inspect/parting/align_stories.h"

namespace ps::parting {

/// The events of a story by what is right below what.
class EventTree {
 public:
  explicit EventTree(const PixelStory& story);
  /// Indices of the events right below `event`, in order; of the roots for -1.
  const std::vector<int>& below(int event) const {
    return children_[event < 0 ? children_.size() - 1 : static_cast<std::size_t>(event)];
  }
  const Event& event(int index) const { return story_.events[static_cast<std::size_t>(index)]; }
  const PixelStory& story() const { return story_; }

 private:
  const PixelStory& story_;
  std::vector<std::vector<int>> children_;  // of each event; the last entry holds the roots
};

/// Positions of the longest common sequence of two lists. Very long lists are matched greedily.
std::vector<std::pair<std::size_t, std::size_t>> common_sequence(const std::vector<std::string>& a,
                                                                 const std::vector<std::string>& b);

/// The rows for the story of a ray beside that of fragments: what the eye ray did one by one beside what became of the
/// triangles, its hit beside the fragment that is seen, and what follows from both. The fragment that is seen comes
/// after the others, whatever the order of drawing, since its lighting is evaluated last on the other side, too. In the
/// rows, `a` is the ray's. Nothing if one of them saw the background alone.
std::vector<AlignedRow> align_ray_and_fragment(const EventTree& ray, const EventTree& fragment, const Scene& scene);

}  // namespace ps::parting
