#include "gui/panels/lesson/notes_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/lesson_length.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// The notes of the lesson, if its first step is open, and those of the step.
std::vector<TextBlock> notes_at(const Lesson& lesson, int step) {
  std::vector<TextBlock> notes;
  if (step == 0) notes = lesson.notes;
  const std::vector<TextBlock>& own = lesson.steps[static_cast<std::size_t>(step)].notes;
  notes.insert(notes.end(), own.begin(), own.end());
  return notes;
}

std::optional<LinkTarget> draw_notes(Session& session, const std::vector<TextBlock>& notes) {
  std::vector<TextLine> lines;
  const float width = ImGui::GetContentRegionAvail().x;
  std::string words;
  for (const TextBlock& block : notes) {
    lay_out(block, mark_of(block), Face::body, width, lines);
    words += (words.empty() ? "" : " ") + plain_text(block);
  }
  auto followed = draw_text_lines(session, lines, width);
  controls().record("text", words);
  return followed;
}

}  // namespace

void NotesSheet::add_actions(Actions& actions) {
  ActionGroup(actions, "Lesson", [this] {
    return !session_.document().lesson.empty();
  }).add("notes", "Notes for the teacher on this step", "Shift+T", [this] { open_ = just_opened_ = !open_; });
}

void NotesSheet::draw_sheet() {
  const Lesson* lesson = shelf_.open();
  const int count = static_cast<int>(lesson->steps.size());
  const int index = std::clamp(session_.document().step, 0, count - 1);
  quiet_text(fmt::format("Step {} of {}: {}", index + 1, count, lesson->steps[static_cast<std::size_t>(index)].title));
  if (index == 0) quiet_text("The lesson takes " + length_text(length_of(*lesson)) + ".");
  ImGui::Dummy({0, px(4)});
  const std::vector<TextBlock> notes = notes_at(*lesson, index);
  ImGui::BeginChild("##text");
  std::optional<LinkTarget> followed;
  if (notes.empty())
    quiet_text("This step has no notes.");
  else
    followed = draw_notes(session_, notes);
  ImGui::EndChild();
  if (!followed) return;
  open_ = false;
  host_.send(*followed);
}

}  // namespace ps::gui
