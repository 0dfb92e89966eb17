#pragma once
#include <string>

#include "gui/panels/story/pin_view.h"
#include "record/story.h"

namespace ps::gui {

/// The pixel's colour as an indented sum with its numbers aligned. Answers the event of the line that was clicked, or
/// -1. Lines of `selected_event` are marked. With `pinned` the numbers of then are above those that changed.
int ledger_view(const std::string& name, const PixelStory& story, int selected_event,
                const PinnedStory* pinned = nullptr);

}  // namespace ps::gui
