#pragma once
#include <array>
#include <memory>
#include <vector>

#include "gui/app/session.h"
#include "inspect/story_changes.h"

namespace ps::gui {

/// A story beside the pinned one of the same pixel.
struct PinnedStory {
  std::shared_ptr<const PixelStory> before;
  StoryChanges changes;
  std::vector<int> steps;  ///< of each event of the later story: index into changes.steps
  std::vector<int> terms;  ///< of each line of its sum: index into changes.ledger

  /// What became of an event or a line of the later story.
  const StepChange& step_of(int event) const {
    return changes.steps[static_cast<std::size_t>(steps[static_cast<std::size_t>(event)])];
  }
  const LedgerChange& term_of(std::size_t line) const { return changes.ledger[static_cast<std::size_t>(terms[line])]; }
};

/// A pixel that was pinned: its stories as they were then, to be compared with those of now.
struct PinState {
  std::array<std::shared_ptr<const PixelStory>, 2> pinned;
  std::array<Settings, 2> settings;  ///< of then
  // What was compared last, for each side.
  std::array<std::shared_ptr<const PixelStory>, 2> compared;
  std::array<PinnedStory, 2> stories;
  std::array<bool, 2> open{true, true};

  bool any() const { return pinned[0] || pinned[1]; }
};

/// The button that pins the picked pixel, or lets it go.
void pin_button(Session& session, PinState& state);

/// The story beside the one that was pinned, for old → new beside its numbers; nullptr while nothing is pinned or the
/// pinned pixel is another one.
const PinnedStory* pinned_story(const Session& session, PinState& state, Side side,
                                const std::shared_ptr<const PixelStory>& story);

/// What has no place among the numbers, as a section of the pixel's panel: which options differ from then, the colour,
/// and the events that are gone. Draws nothing while nothing is pinned.
void pin_view(Session& session, PinState& state, Side side, const std::shared_ptr<const PixelStory>& story);

}  // namespace ps::gui
