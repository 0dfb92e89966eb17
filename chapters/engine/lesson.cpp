#include "engine/lesson.h"

#include <fmt/format.h>
#include <lessons_table.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/resources.h"
#include "base/spelling.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_lesson = 1u << 20;  // bytes

}  // namespace

std::vector<std::string> lesson_names() {
#define PS_LESSON_NAME(folder) names.push_back(#folder);
  std::vector<std::string> names;
  PS_LESSONS(PS_LESSON_NAME)
#undef PS_LESSON_NAME
  return names;
}

Lesson load_lesson(const std::string& name) {
  const LessonPlace place = parse_lesson_place(name);
  const std::filesystem::path file = lesson_file(place.lesson);
  return parse_lesson(read_whole_file(file, largest_lesson), place.lesson, file.string());
}

}  // namespace ps
