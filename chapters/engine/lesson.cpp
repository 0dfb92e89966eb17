#include "engine/lesson.h"

#include <fmt/format.h>
#include <lessons_table.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/resources.h"
#include "engine/course.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_lesson = 1u << 20;  // bytes

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

}  // namespace

std::vector<std::string> lesson_folders() {
#define PS_LESSON_NAME(folder) names.push_back(#folder);
  std::vector<std::string> names;
  PS_LESSONS(PS_LESSON_NAME)
#undef PS_LESSON_NAME
  return names;
}

const std::vector<std::string>& lesson_names() {
  static const std::vector<std::string> names = names_in_order();
  return names;
}

Lesson load_lesson(const std::string& name) {
  const LessonPlace place = parse_lesson_place(name);
  const std::filesystem::path file = lesson_file(place.lesson);
  return parse_lesson(read_whole_file(file, largest_lesson), place.lesson, file.string());
}

}  // namespace ps
