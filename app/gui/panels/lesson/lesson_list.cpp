#include "gui/panels/lesson/lesson_list.h"

#include <fmt/format.h>

#include "base/check.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

struct ListedLesson {
  std::string name, title, source;
  std::size_t steps = 0;
};

/// Those that cannot be read are left out; the lesson menu says what is wrong with them.
std::vector<ListedLesson> readable_lessons() {
  std::vector<ListedLesson> lessons;
  for (const auto& name : lesson_names()) {
    try {
      const Lesson lesson = load_lesson(name);
      lessons.push_back({name, lesson.title, lesson.source, lesson.steps.size()});
    } catch (const InputError&) {
      continue;
    }
  }
  return lessons;
}

}  // namespace

void lesson_list(Session& session) {
  const NameScope scope("lessons");
  static const std::vector<ListedLesson> lessons = readable_lessons();
  ImGui::BeginChild("lessons");
  for (const ListedLesson& lesson : lessons) {
    if (tree_row(lesson.name, fmt::format("{}   {} steps", lesson.title, lesson.steps), TreeKind::leaf, false).clicked)
      go_to_step(session, lesson.name, 0);
    tooltip(lesson.source);
  }
  ImGui::EndChild();
}

}  // namespace ps::gui
