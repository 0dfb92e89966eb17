#include "gui/panels/lesson/lesson_picker.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <set>

#include "base/spelling.h"
#include "gui/panels/lesson/hit_row.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/picture_tiles.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// Picture A of the first step that does not cover it with a question.
Image<Rgb8> lesson_picture(const std::string& name, int width, int height, Progress& progress) {
  const Lesson lesson = load_lesson(name);
  const auto shows_a = [](const LessonStep& step) { return !step.question || !step.question->hidden[0]; };
  const auto first = std::find_if(lesson.steps.begin(), lesson.steps.end(), shows_a);
  if (first == lesson.steps.end()) return {};
  Prepared own;  // what a scene needs for its picture is not kept
  const Document document = lesson_document(lesson, static_cast<int>(first - lesson.steps.begin()), {});
  return thumbnail_of_a(document, width, height, own, progress);
}

/// The picture of a lesson by its number in the list; nullptr while it is being made.
const Texture* picture_of(Thumbnails& thumbnails, std::size_t number, int width, int height) {
  return thumbnails.find(number, width, height,
                         [name = listed_lessons()[number].name, width, height](Prepared&, Progress& progress) {
                           return lesson_picture(name, width, height, progress);
                         });
}

std::vector<std::size_t> readable_numbers() {
  std::vector<std::size_t> numbers;  // the lesson menu says what is wrong with the others
  for (std::size_t i = 0; i < listed_lessons().size(); ++i)
    if (listed_lessons()[i].fault.empty()) numbers.push_back(i);
  return numbers;
}

std::string counted(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace

/// All lessons, a heading over each part of the course.
LessonPicker::Chosen LessonPicker::lesson_tiles() {
  Chosen chosen;
  const std::vector<std::size_t> numbers = readable_numbers();
  PictureTiles tiles(selected_, numbers.size(), {.lines = 3, .reveal = just_opened_});
  std::string_view part;
  for (const std::size_t number : numbers) {
    const ListedLesson& lesson = listed_lessons()[number];
    if (lesson.part != part) tiles.heading(lesson.part);
    part = lesson.part;
    const bool is_read = read_.names.contains(lesson.name);
    if (tiles.tile({.name = lesson.name,
                    .title = lesson.title,
                    .note = short_length(lesson.length),
                    .ticked = is_read,
                    .tooltip = lesson_tooltip(lesson, read_),
                    .picture = [&](int width, int height) { return picture_of(thumbnails_, number, width, height); }}))
      chosen = {lesson.name, 0};
    controls().record(lesson.name + "/read", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), is_read ? "on" : "off");
  }
  if (key_pressed(Key::enter) && !numbers.empty())
    chosen = {listed_lessons()[numbers[static_cast<std::size_t>(selected_)]].name, 0};
  return chosen;
}

/// What has the words of the query, best first.
LessonPicker::Chosen LessonPicker::hit_rows() {
  Chosen chosen;
  const std::vector<LessonHit>& hits = found_.hits;
  const int before = selected_, last = static_cast<int>(hits.size()) - 1;
  if (key_pressed(Key::down)) ++selected_;
  if (key_pressed(Key::up)) --selected_;
  selected_ = std::clamp(selected_, 0, std::max(last, 0));
  for (int i = 0; i <= last; ++i) {
    const LessonHit& hit = hits[static_cast<std::size_t>(i)];
    const HitRow row{.hit = hit,
                     .lesson = listed_lessons()[hit.lesson],
                     .name = fmt::format("hit-{}", i),
                     .ticked = read_.names.contains(listed_lessons()[hit.lesson].name),
                     .selected = i == selected_,
                     .reveal = selected_ != before};
    const int size = tile_picture_size();
    const auto picture = [&] { return picture_of(thumbnails_, hit.lesson, size, size); };
    if (hit_row(row, picture) || (i == selected_ && key_pressed(Key::enter)))
      chosen = {listed_lessons()[hit.lesson].name, hit.step};
  }
  return chosen;
}

/// How much was found.
std::string LessonPicker::found_text() const {
  if (search_.find_first_not_of(' ') == std::string::npos) return counted(readable_numbers().size(), "lesson");
  const LessonHits& found = found_;
  if (found.hits.empty()) return "Nothing found";
  std::set<std::size_t> lessons;
  for (const LessonHit& hit : found.hits) lessons.insert(hit.lesson);
  return counted(found.hits.size(), "place") + " in " + counted(lessons.size(), "lesson");
}

/// What can be done where nothing has the words, or which words were sought in their place.
void LessonPicker::help_with_query() {
  const LessonHits& found = found_;
  if (!found.alike.empty()) {
    constexpr std::size_t most = 5;
    const std::vector<std::string> few(
        found.alike.begin(), found.alike.begin() + static_cast<std::ptrdiff_t>(std::min(most, found.alike.size())));
    value_paragraph("alike", fmt::format("No lesson has these words as typed. Similar: {}", fmt::join(few, ", ")));
  }
  if (!found.hits.empty() || searched_.empty()) return;
  if (found.unknown.empty())
    return value_paragraph("nothing",
                           "Lessons have each of these words, but no step has all of them. Remove a word, or clear the "
                           "field with the cross at its end.");
  value_paragraph("nothing", fmt::format("No lesson has \"{}\". The cross at the end of the field clears it.",
                                         shown_start(found.unknown)));
  if (found.nearest.empty()) return;
  const bool clicked = button("nearest", fmt::format("Search for \"{}\" (Enter)", found.nearest));
  if (clicked || key_pressed(Key::enter)) search_ = found.nearest;
}

void LessonPicker::follow_query() {
  const bool blank = search_.find_first_not_of(' ') == std::string::npos;
  const std::string wanted = blank ? std::string() : search_;
  if (searched_ == wanted) return;
  searched_ = wanted;
  found_ = lesson_index().find(wanted);
  selected_ = 0;
}

void LessonPicker::title_row() {
  {
    const FontScope title(Face::heading);
    ImGui::TextUnformatted("Lessons");
  }
  ImGui::SameLine(px(140));
  if (just_opened_ || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  const float top = ImGui::GetCursorPosY();
  // What is counted, and the button, keep their places.
  const float rest = px(140) + text_width("  999 places in 99 lessons") + px(24 + 84 + 24);
  const float width = std::clamp(ImGui::GetWindowWidth() - rest, px(160), px(340));
  search_box("search", search_, "Search all texts", {.tooltip = {}, .disabled = {}, .width = width});
  follow_query();
  ImGui::SameLine();
  ImGui::SetCursorPosY(top);
  ImGui::AlignTextToFramePadding();
  value_text("count", found_text());
  if (close_at_end()) open_ = false;
  ImGui::Dummy({0, px(2)});
}

void LessonPicker::add_actions(Actions& actions) {
  ActionGroup(actions, "Lesson").add("lessons", "Find a lesson: pictures, and a search in all texts", "Ctrl+L", [this] {
    show();
  });
}

void LessonPicker::offer(Values& out) {
  Sheet::offer(out);
  out.offer("picker/pictures", [this] { return static_cast<int>(thumbnails_.count()); });
}

void LessonPicker::show() {
  open();
  search_.clear();
  const std::vector<std::size_t> numbers = readable_numbers();
  const auto here = std::find_if(numbers.begin(), numbers.end(), [&](std::size_t number) {
    return listed_lessons()[number].name == session_.document().lesson;
  });
  selected_ = here == numbers.end() ? 0 : static_cast<int>(here - numbers.begin());
  searched_.clear();
  found_ = {};
}

void LessonPicker::draw_sheet() {
  title_row();
  help_with_query();
  ImGui::BeginChild("##lessons");
  const Chosen chosen = searched_.empty() ? lesson_tiles() : hit_rows();
  ImGui::EndChild();
  if (chosen && !just_opened_) {  // the Enter that opened it does not count
    open_ = false;
    go_to_step(session_, chosen->lesson, chosen->step);
  }
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < listed_lessons().size(); ++i) ids.insert(i);
  thumbnails_.update(ids);
}

}  // namespace ps::gui
