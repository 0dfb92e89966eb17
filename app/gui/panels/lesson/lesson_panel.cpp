#include "gui/panels/lesson/lesson_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "gui/panels/lesson/step_controls.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// rich_text knows bold and code; *emphasis* reads as well without its marks.
std::string without_emphasis(const std::string& text) {
  static const std::regex mark(R"((^|[^*])\*([^*\s](?:[^*]*[^*\s])?)\*(?!\*))");
  return std::regex_replace(text, mark, "$1$2");
}

void quiet_line(const char* name, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  value_paragraph(name, text);
  ImGui::PopStyleColor();
}

}  // namespace

const Lesson* LessonShelf::open(Session& session) {
  const std::string& wanted = session.document().lesson;
  if (wanted.empty()) return nullptr;
  if (wanted != name_) {
    name_ = wanted;
    lesson_.reset();
    try {
      lesson_ = load_lesson(wanted);
    } catch (const InputError& error) {
      session.say(Message::Kind::error, error.what());
    }
  }
  return lesson_ ? &*lesson_ : nullptr;
}

void go_to_step(Session& session, const std::string& name, int step) {
  try {
    const Lesson lesson = load_lesson(name);
    if (lesson.steps.empty()) return;
    const int last = static_cast<int>(lesson.steps.size()) - 1;
    const int target = std::clamp(step, 0, last);
    session.edit(fmt::format("{}, step {}", lesson.title, target + 1),
                 [&](Document& document) { document = lesson_document(lesson, target, document); });
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
}

void move_step(Session& session, LessonShelf& shelf, int by) {
  const Lesson* lesson = shelf.open(session);
  if (!lesson) return;
  const int step = session.document().step + by;
  if (step >= 0 && step < static_cast<int>(lesson->steps.size())) go_to_step(session, lesson->name, step);
}

void read_lesson(Session& session, LessonShelf& shelf, int by) {
  LessonText& text = shelf.text;
  const bool in_sight = text.frame + 1 >= ImGui::GetFrameCount();
  if (in_sight && (by > 0 ? text.below : text.above) > 1)
    text.turn += by;
  else
    move_step(session, shelf, by);
}

void move_lesson(Session& session, int by) {
  const auto names = lesson_names();
  if (names.empty()) return;
  const auto here = std::find(names.begin(), names.end(), session.document().lesson);
  if (here == names.end()) {
    go_to_step(session, names.front(), 0);
    return;
  }
  const auto place = std::distance(names.begin(), here) + by;
  if (place >= 0 && place < std::ssize(names)) go_to_step(session, names[static_cast<std::size_t>(place)], 0);
}

int pages_of(const LessonText& text) {
  const float hidden = text.above + text.below;
  return hidden > 1 ? 1 + static_cast<int>(std::ceil(hidden / text.page)) : 1;
}

void close_lesson(Session& session) {
  session.navigate([](Document& document) { document.mode = ScreenMode::explore; });
  session.edit("close the lesson", [](Document& document) {
    document.lesson.clear();
    document.step = 0;
  });
}

namespace {

/// Turns the pages that were asked for in the child window that holds the text, and notes what is in sight. A new step
/// begins at the top.
void turn_pages(LessonText& text, const std::string& lesson, int step) {
  if (text.lesson != lesson || text.step != step) {
    text = {};
    text.lesson = lesson;
    text.step = step;
    ImGui::SetScrollY(0);
  } else if (text.turn != 0) {
    ImGui::SetScrollY(
        std::clamp(ImGui::GetScrollY() + static_cast<float>(text.turn) * text.page, 0.f, ImGui::GetScrollMaxY()));
    text.turn = 0;
  }
  const float line = ImGui::GetTextLineHeight();
  text.page = std::max(ImGui::GetWindowHeight() - 2 * line, line);  // two lines stay in sight
  text.above = ImGui::GetScrollY();
  text.below = ImGui::GetScrollMaxY() - ImGui::GetScrollY();
  text.frame = ImGui::GetFrameCount();
}

}  // namespace

void lesson_panel(Session& session, LessonShelf& shelf) {
  const NameScope scope("lesson");
  const Lesson* lesson = shelf.open(session);
  if (!lesson || lesson->steps.empty()) return;
  const int count = static_cast<int>(lesson->steps.size());
  const int index = std::clamp(session.document().step, 0, count - 1);
  const auto& step = lesson->steps[static_cast<std::size_t>(index)];
  {
    const FontScope font(Face::heading);
    ImGui::TextWrapped("%s", lesson->title.c_str());
  }
  quiet_line("place", fmt::format("step {} of {}", index + 1, count));

  const float buttons = ImGui::GetFrameHeightWithSpacing() + px(4);
  ImGui::BeginChild("text", {0, -buttons});
  // Where the panel is small, each line that does not scroll is one less to read.
  if (index == 0) quiet_line("source", lesson->source);
  std::string text;
  if (index == 0)
    for (const auto& paragraph : lesson->paragraphs) text += paragraph + "\n\n";
  text += "## " + step.title + "\n\n";
  for (const auto& paragraph : step.paragraphs) text += paragraph + "\n\n";
  for (const auto& hint : step.hints) text += "- " + hint + "\n";
  rich_text(without_emphasis(text));
  if (session.document().mode == ScreenMode::lesson) step_controls(session, step);
  turn_pages(shelf.text, lesson->name, index);
  const bool above = shelf.text.above > 1, below = shelf.text.below > 1;
  controls().record("hidden", above && below ? "both" : above ? "above" : below ? "below" : "none");
  ImGui::EndChild();

  int target = index;
  if (button("before", "Back", Emphasis::plain,
             {.tooltip = "The previous step (Page Up). Shift Page Up reads back.",
              .disabled = index == 0 ? "This is the first step." : ""}))
    target = index - 1;
  ImGui::SameLine();
  if (button("next", "Next", Emphasis::primary,
             {.tooltip = "The next step (Enter or Page Down). Shift Page Down reads on.",
              .disabled = index + 1 == count ? "This is the last step." : ""}))
    target = index + 1;
  ImGui::SameLine();
  if (button("again", "Again", Emphasis::quiet, {.tooltip = "Puts this step's settings back.", .disabled = {}}))
    go_to_step(session, lesson->name, index);
  ImGui::SameLine();
  const bool close = button("close", "×", Emphasis::quiet, {.tooltip = "Closes the lesson.", .disabled = {}});
  if (target != index) go_to_step(session, lesson->name, target);
  if (close) close_lesson(session);
}

}  // namespace ps::gui
