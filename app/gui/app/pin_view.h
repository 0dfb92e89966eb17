#pragma once
#include <array>
#include <memory>

#include "gui/app/session.h"
#include "inspect/story_changes.h"

namespace ps::gui {

/// A pixel that was pinned: its stories as they were then, to be compared with those of now.
struct PinState {
  std::array<std::shared_ptr<const PixelStory>, 2> pinned;
  std::array<Settings, 2> settings;  ///< of then
  // What was compared last, for each side.
  std::array<std::shared_ptr<const PixelStory>, 2> compared;
  std::array<StoryChanges, 2> changes;
  std::array<bool, 2> open{true, true};
  bool only_changes = true;

  bool any() const { return pinned[0] || pinned[1]; }
};

/// The button that pins the picked pixel, or lets it go.
void pin_button(Session& session, PinState& state);

/// Old beside new for every number of the pinned pixel, as a section of the pixel's panel. Answers the event that was
/// clicked, or -1. Draws nothing while nothing is pinned.
int pin_view(Session& session, PinState& state, Side side, const std::shared_ptr<const PixelStory>& story);

}  // namespace ps::gui
