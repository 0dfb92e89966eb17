#include "engine/lesson.h"

#include <fmt/format.h>
#include <lessons_table.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/resources.h"
#include "engine/course.h"
#include "engine/words.h"
#include "options/option.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_lesson = 1u << 20;  // bytes

bool is_here(std::string_view renderer) {
  const auto kinds = renderer_kinds();
  return std::any_of(kinds.begin(), kinds.end(), [&](const RendererKind& kind) { return kind.key == renderer; });
}

/// The text behind "renderer:" before the first step; empty without such a line and where the file cannot be read.
std::string needed_renderer(const std::string& name) {
  constexpr std::string_view word = "renderer:";
  try {
    const std::string file = read_whole_file(lesson_file(name), largest_lesson);
    std::string_view text = file;
    while (!text.empty()) {
      const std::string_view line = take_line(text);
      if (line.starts_with("## ")) break;
      if (line.starts_with(word)) return std::string(without_blanks(line.substr(word.size())));
    }
  } catch (const InputError&) {
    // load_lesson() reports it.
  }
  return {};
}

struct KnownLessons {
  std::vector<std::string> names;
  std::vector<LeftOutLesson> left_out;
};

std::vector<std::string> names_in_order() {
  std::vector<std::string> folders = lesson_folders();
  try {
    std::vector<std::string> names = lessons_of(load_course());
    std::erase_if(folders,
                  [&](const std::string& each) { return std::find(names.begin(), names.end(), each) != names.end(); });
    names.insert(names.end(), folders.begin(), folders.end());
    return names;
  } catch (const InputError&) {
    return folders;  // the lists of lessons report what is wrong with the course
  }
}

const KnownLessons& known_lessons() {
  static const KnownLessons known = [] {
    KnownLessons all;
    for (const std::string& name : names_in_order()) {
      const std::string renderer = needed_renderer(name);
      if (renderer.empty() || is_here(renderer))
        all.names.push_back(name);
      else
        all.left_out.push_back({name, renderer});
    }
    return all;
  }();
  return known;
}

}  // namespace

std::vector<std::string> lesson_folders() {
#define PS_LESSON_NAME(folder) names.push_back(#folder);
  std::vector<std::string> names;
  PS_LESSONS(PS_LESSON_NAME)
#undef PS_LESSON_NAME
  return names;
}

const std::vector<std::string>& lesson_names() { return known_lessons().names; }

const std::vector<LeftOutLesson>& lessons_left_out() { return known_lessons().left_out; }

std::optional<std::string> why_not_here(const Lesson& lesson) {
  if (lesson.renderer.empty()) return {};
  Settings settings;
  parse_assignment("renderer=" + lesson.renderer, settings);
  const RendererKind& kind = renderer_kind(settings.renderer);
  const auto reason = kind.inactive ? kind.inactive(settings, SceneTraits{}) : std::nullopt;
  if (!reason) return {};
  return reason->text();
}

Lesson load_lesson(const std::string& name) {
  const LessonPlace place = parse_lesson_place(name);
  const std::filesystem::path file = lesson_file(place.lesson);
  return parse_lesson(read_whole_file(file, largest_lesson), place.lesson, file.string());
}

}  // namespace ps
