#pragma once
#include <optional>

#include "engine/lesson.h"
#include "gui/panels/lesson/text_view.h"

namespace ps::gui {

/// What a lesson has for the teacher alone, over the window.
struct NotesState {
  bool open = false, just_opened = false;
};

/// Opens or closes it.
void toggle_notes(NotesState& state);

/// Draws the notes of the open step while they are asked for; with the first step those of the whole lesson. It closes
/// where no lesson is open (nullptr). Answers a link that was followed, which also closes it.
std::optional<LinkTarget> notes_sheet(Session& session, NotesState& state, const Lesson* lesson);

}  // namespace ps::gui
