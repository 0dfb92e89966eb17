#include "engine/lesson_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/check.h"
#include "base/number_text.h"
#include "base/resources.h"
#include "base/spelling.h"
#include "engine/course.h"

namespace ps {
namespace {

constexpr int most_steps = 1000;

bool is_left_out(std::string_view name) {
  const std::vector<LeftOutLesson>& all = lessons_left_out();
  return std::any_of(all.begin(), all.end(), [&](const LeftOutLesson& each) { return each.name == name; });
}

}  // namespace

bool is_built_in(std::string_view name) {
  const std::vector<std::string>& names = lesson_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

LessonPlace parse_built_in_place(std::string_view text) {
  const auto slash = text.find('/');
  const std::string folder(text.substr(0, slash));
  const int step = slash == std::string_view::npos ? 0 : parse_step_number(text.substr(slash + 1));
  if (!is_built_in(folder)) {
    if (auto successor = successor_of({folder, step})) return *std::move(successor);
    for (const LeftOutLesson& each : lessons_left_out())
      if (each.name == folder)
        throw InputError(fmt::format("the lesson '{}' needs the renderer '{}', which this program was built without",
                                     folder, each.renderer));
    const std::vector<std::string_view> known(lesson_names().begin(), lesson_names().end());
    throw InputError(fmt::format("unknown lesson '{}'{}", folder,
                                 did_you_mean(folder, known, "; 'pixelscope-cli lessons list' lists them")));
  }
  return {folder, step};
}

int parse_step_number(std::string_view text) {
  const auto number = parse_integer<int>(text);
  if (!number || *number < 1 || *number > most_steps)
    throw InputError(fmt::format("found the step '{}', expected a whole number from 1", text));
  return *number - 1;
}

std::string lesson_folder_at(const std::filesystem::path& path) {
  const std::string text_name = lesson_file("x").filename().string();
  std::error_code error;
  std::filesystem::path folder = std::filesystem::absolute(path, error).lexically_normal();
  if (path.empty() || error) return {};
  if (folder.filename() == text_name || !folder.has_filename()) folder = folder.parent_path();
  return std::filesystem::is_regular_file(folder / text_name, error) ? folder.string() : std::string{};
}

bool is_own_lesson(std::string_view name) { return name.find('/') != std::string_view::npos; }

LessonPlace parse_lesson_place(std::string_view text) {
  const std::string_view first = text.substr(0, text.find('/'));
  if (is_built_in(first) || is_left_out(first)) return parse_built_in_place(text);
  if (std::string folder = lesson_folder_at(text); !folder.empty()) return {std::move(folder), 0};
  const auto slash = text.rfind('/');
  if (slash == std::string_view::npos) return parse_built_in_place(text);
  if (std::string folder = lesson_folder_at(text.substr(0, slash)); !folder.empty())
    return {std::move(folder), parse_step_number(text.substr(slash + 1))};
  if (successor_of({std::string(text.substr(0, slash)), 0})) return parse_built_in_place(text);
  throw InputError(fmt::format("'{}' is neither a lesson nor a folder with a file lesson.md", text));
}

}  // namespace ps
