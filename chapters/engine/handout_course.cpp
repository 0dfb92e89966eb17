#include <algorithm>

#include <fmt/format.h>

#include "engine/handout.h"
#include "engine/handout_page.h"
#include "engine/lesson_length.h"
#include "image/svg.h"

namespace ps {
namespace {

std::string title_link(const Lesson& lesson) {
  return fmt::format("<a href=\"{}.html\">{}</a>", xml_escaped(lesson.name), xml_escaped(lesson.title));
}

const Lesson* find(const std::vector<Lesson>& lessons, std::string_view name) {
  const auto found =
      std::find_if(lessons.begin(), lessons.end(), [&](const Lesson& lesson) { return lesson.name == name; });
  return found == lessons.end() ? nullptr : &*found;
}

std::string row(const Lesson& lesson, const std::string& after) {
  return fmt::format("<tr><td>{}<br/><span class=\"source\">{}</span></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                     title_link(lesson), xml_escaped(lesson.source), length_of(lesson).minutes(), after,
                     list_html(lesson.goals));
}

std::string table(const std::string& title, const std::string& rows) {
  if (rows.empty()) return {};
  return fmt::format("<h2>{}</h2>\n<table><tr><th>Lesson</th><th>Minutes</th><th>Builds on</th><th>Afterwards you "
                     "can</th></tr>\n{}</table>\n",
                     title, rows);
}

/// The lessons in classes of this length, in their order. A longer lesson fills classes of its own.
std::string plan(const std::vector<const Lesson*>& order, int minutes) {
  std::string rows, names;
  int filled = 0, number = 0;
  const auto end_class = [&] {
    if (names.empty()) return;
    const int classes = std::max(1, (filled + minutes - 1) / minutes);
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        classes == 1 ? fmt::format("{}", number + 1)
                                     : fmt::format("{} and {}", number + 1, number + classes),
                        names, filled);
    number += classes;
    names.clear();
    filled = 0;
  };
  for (const Lesson* lesson : order) {
    const int length = length_of(*lesson).minutes();
    if (filled + length > minutes) end_class();
    names += (names.empty() ? "" : ", ") + title_link(*lesson);
    filled += length;
  }
  end_class();
  return fmt::format(
      "<h2>In classes of {} minutes</h2>\n<table><tr><th>Class</th><th>Lessons</th><th>Minutes</th></tr>\n"
      "{}</table>\n",
      minutes, rows);
}

}  // namespace

std::string handout_index(const Course& course, const std::vector<Lesson>& lessons) {
  std::string body, further;
  std::vector<const Lesson*> order;
  int minutes = 0;
  for (const CoursePart& part : course.parts) {
    std::string rows;
    for (const CourseLesson& each : part.lessons) {
      const Lesson* lesson = find(lessons, each.name);
      if (!lesson) continue;
      std::string after;
      for (const std::string& name : each.after)
        if (const Lesson* earlier = find(lessons, name)) after += (after.empty() ? "" : ", ") + title_link(*earlier);
      rows += row(*lesson, after);
      order.push_back(lesson);
    }
    body += table(xml_escaped(part.title), rows);
  }
  for (const Lesson& lesson : lessons)
    if (std::find(order.begin(), order.end(), &lesson) == order.end()) further += row(lesson, "");
  body += table("Further lessons", further);
  for (const Lesson& lesson : lessons) minutes += length_of(lesson).minutes();
  if (!order.empty())
    for (const int length : {45, 90}) body += plan(order, length);
  const std::string title = course.title.empty() ? "Lessons" : course.title;
  return handout_page(title, fmt::format("<h1>{}</h1>\n<p>{} lessons of about {} minutes together.</p>\n{}",
                                         xml_escaped(title), lessons.size(), minutes, body));
}

}  // namespace ps
