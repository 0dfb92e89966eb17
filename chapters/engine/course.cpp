#include "engine/course.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/resources.h"
#include "base/spelling.h"
#include "engine/block.h"
#include "engine/lesson_place.h"
#include "engine/words.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_course = 1u << 20;  // bytes
constexpr std::string_view earlier_names = "## Earlier names";

class CourseParser {
 public:
  CourseParser(const std::string& file, const std::vector<std::string>& folders) : file_(file), folders_(folders) {}

  void read_line(std::string_view line) {
    ++line_;
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    if (line.starts_with("# ")) {
      if (!course_.title.empty()) throw InputError(place(), "a second title", "one line '# Title'");
      course_.title = line.substr(2);
    } else if (line == earlier_names) {
      in_earlier_names_ = true;
    } else if (in_earlier_names_) {
      if (!line.empty()) read_earlier(line);
    } else if (line.starts_with("## ")) {
      course_.parts.push_back({std::string(line.substr(3)), {}});
    } else if (!course_.parts.empty() && !line.empty()) {
      read_lesson(line);
    }
  }

  Course finish() {
    if (course_.title.empty()) throw InputError({file_, 0, 0}, "no title", "a line '# Title'");
    if (lessons_of(course_).empty()) throw InputError({file_, 0, 0}, "no lessons", "'## Part' and lines '- lesson'");
    return std::move(course_);
  }

 private:
  SourcePlace place() const { return {file_, line_, 1}; }

  void read_lesson(std::string_view line) {
    if (!line.starts_with("- "))
      throw InputError(place(), fmt::format("'{}'", shown_start(line)), "'- lesson' or '- lesson, after lesson'");
    line.remove_prefix(2);
    const auto comma = line.find(", after ");
    CourseLesson lesson{std::string(line.substr(0, comma)), {}};
    require_folder(lesson.name);
    const std::vector<std::string> before = lessons_of(course_);
    if (std::find(before.begin(), before.end(), lesson.name) != before.end())
      throw InputError(place(), fmt::format("'{}' a second time", lesson.name), "each lesson once");
    if (comma != std::string_view::npos) lesson.after = read_after(line.substr(comma + 8), before);
    course_.parts.back().lessons.push_back(std::move(lesson));
  }

  void read_earlier(std::string_view line) {
    const auto now = line.find(", now ");
    if (!line.starts_with("- ") || now == std::string_view::npos)
      throw InputError(place(), fmt::format("'{}'", shown_start(line)), "'- earlier name, now lesson/STEP'");
    EarlierName earlier{std::string(line.substr(2, now - 2)), {}};
    const std::string_view target = line.substr(now + 6);
    const auto slash = target.find('/');
    earlier.now.lesson = target.substr(0, slash);
    require_folder(earlier.now.lesson);
    if (slash != std::string_view::npos)
      at_place(place(), [&] { earlier.now.step = parse_step_number(target.substr(slash + 1)); });
    const bool again = std::any_of(course_.earlier.begin(), course_.earlier.end(),
                                   [&](const EarlierName& each) { return each.name == earlier.name; });
    if (again || std::find(folders_.begin(), folders_.end(), earlier.name) != folders_.end())
      throw InputError(place(), fmt::format("'{}', which is {}", earlier.name, again ? "there twice" : "a lesson"),
                       "a name that no lesson has any more");
    course_.earlier.push_back(std::move(earlier));
  }

  std::vector<std::string> read_after(std::string_view list, const std::vector<std::string>& before) const {
    std::vector<std::string> after;
    for (;;) {
      const auto comma = list.find(", ");
      after.emplace_back(list.substr(0, comma));
      require_folder(after.back());
      if (std::find(before.begin(), before.end(), after.back()) == before.end())
        throw InputError(place(), fmt::format("after '{}', which is not before it", after.back()), "an earlier lesson");
      if (comma == std::string_view::npos) return after;
      list.remove_prefix(comma + 2);
    }
  }

  void require_folder(const std::string& name) const {
    if (std::find(folders_.begin(), folders_.end(), name) != folders_.end()) return;
    const std::vector<std::string_view> known(folders_.begin(), folders_.end());
    throw InputError(place(), fmt::format("'{}', which is not a lesson", shown_start(name)),
                     fmt::format("a folder with a lesson.md{}", did_you_mean(name, known, "")));
  }

  std::string file_;
  const std::vector<std::string>& folders_;
  Course course_;
  bool in_earlier_names_ = false;
  int line_ = 0;
};

}  // namespace

Course parse_course(std::string_view text, const std::string& file, const std::vector<std::string>& folders) {
  CourseParser parser(file, folders);
  while (!text.empty()) parser.read_line(take_line(text));
  return parser.finish();
}

Course load_course() {
  const std::filesystem::path file = course_file();
  return parse_course(read_whole_file(file, largest_course), file.string(), lesson_folders());
}

std::vector<std::string> lessons_of(const Course& course) {
  std::vector<std::string> names;
  for (const CoursePart& part : course.parts)
    for (const CourseLesson& lesson : part.lessons) names.push_back(lesson.name);
  return names;
}

std::optional<LessonPlace> successor_in(const Course& course, const LessonPlace& place) {
  for (const EarlierName& each : course.earlier)
    if (each.name == place.lesson) return LessonPlace{each.now.lesson, each.now.step + place.step};
  return {};
}

std::optional<LessonPlace> successor_of(const LessonPlace& place) {
  try {
    return successor_in(load_course(), place);
  } catch (const InputError&) {
    return {};  // the lists of lessons report what is wrong with the course
  }
}

std::string_view part_title(const Course& course, std::string_view lesson) {
  for (const CoursePart& part : course.parts)
    for (const CourseLesson& each : part.lessons)
      if (each.name == lesson) return part.title;
  return {};
}

}  // namespace ps
