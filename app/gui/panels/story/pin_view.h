#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/session/session.h"
#include "inspect/story_changes.h"

namespace ps::gui {

/// A story beside the pinned one of the same pixel.
struct PinnedStory {
  std::shared_ptr<const PixelStory> before;
  StoryChanges changes;
  std::vector<int> steps;  ///< of each event of the later story: index into changes.steps
  std::vector<int> terms;  ///< of each line of its sum: index into changes.ledger

  /// The change of an event or a line of the later story.
  const StepChange& step_of(int event) const {
    return changes.steps[static_cast<std::size_t>(steps[static_cast<std::size_t>(event)])];
  }
  const LedgerChange& term_of(std::size_t line) const { return changes.ledger[static_cast<std::size_t>(terms[line])]; }
};

/// The stories of the document's pinned pixel, as they were when it was pinned.
struct PinState {
  /// `wake` is called from other threads when a story has come.
  explicit PinState(const std::function<void()>& wake);

  std::optional<Pin> shown_pin;  ///< the pin that the stories below belong to,
  std::string shown_scene;       ///< in this scene
  std::array<std::shared_ptr<const PixelStory>, 2> pinned;
  // The stories compared last, for each side.
  std::array<std::shared_ptr<const PixelStory>, 2> compared;
  std::array<PinnedStory, 2> stories;
  std::array<bool, 2> open{true, true};
  /// Requests the stories of a pin that comes from a permalink or from undo.
  std::array<std::unique_ptr<InspectWorker>, 2> workers;
  std::shared_ptr<Prepared> prepared;  ///< for these, so that they do not push out what the pictures need
};

/// Once a frame: requests the stories of the document's pin if they are missing.
void update_pin(Session& session, PinState& state);
/// Some of them is still to come, or has come and was not taken up.
bool pin_busy(const PinState& state);

/// The button that pins the picked pixel, or lets it go.
void pin_button(Session& session);

/// The story beside the one that was pinned, for old → new beside its numbers; nullptr while none is pinned or the
/// pinned pixel is another one.
const PinnedStory* pinned_story(const Session& session, PinState& state, Side side,
                                const std::shared_ptr<const PixelStory>& story);

/// The changes without a place among the numbers, as a section of the pixel's panel: what was changed since then, the
/// colour, and the events that are gone. Not drawn while none is pinned.
void pin_view(Session& session, PinState& state, Side side, const std::shared_ptr<const PixelStory>& story);

}  // namespace ps::gui
