#include "engine/bug_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "frame/display_frame.h"
#include "options/renderer_kind.h"
#include "render/render.h"

namespace ps {
namespace {

const ListingBug& bug_named(const std::string& name) {
  const auto all = listing_bugs();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ListingBug& bug) { return bug.name == name; });
  PS_ASSERT(found != all.end(), "listings run only bugs that are there");
  return *found;
}

/// The bug that A runs; empty: none.
std::string bug_of_a(const Document& document) {
  const Settings& settings = document.a.settings;
  if (!runs_listing(settings.renderer)) return {};
  return running_listing(settings, scene_traits(document.scene)).bug;
}

ListingText text_of(const ListingBug& bug) {
  return load_listing_text({std::string(bug.folder), {}, bug.listing, std::string(bug.name)});
}

/// The place of a line among those that are shown; behind the last one if it is not.
std::size_t place_of(const ListingText& text, int number) {
  const auto found = std::find_if(text.lines.begin(), text.lines.end(),
                                  [&](const ListingLine& line) { return line.number == number; });
  return static_cast<std::size_t>(found - text.lines.begin());
}

Image<Rgb8> picture(const Document& document, Side side, Progress& progress) {
  Prepared prepared;
  const Settings& settings = side_of(document, side).settings;
  return display_frame(render(document.scene, view_of(document), settings, {}, prepared, progress), settings);
}

/// Checks that need the document alone.
std::string check_sides(const Document& document) {
  Settings cured = document.a.settings;
  cured.listing_bug = 0;
  if (cured != document.b.settings) return "B is not the listing of A without its bug";
  if (document.pixel.x < 0) return "no pixel is picked";
  return document.picked == Side::a ? "" : "the picked pixel is one of B";
}

}  // namespace

MeasuredAnswer find_bug(const LessonQuestion& question) {
  MeasuredAnswer answer;
  answer.bug = bug_of_a(state_document(question.state, Document{}));
  if (answer.bug.empty()) throw InputError("A runs no listing with a bug");
  answer.line = bug_line(bug_named(answer.bug));
  return answer;
}

Judgement judge_line(const LessonQuestion& question, int line, const MeasuredAnswer& right) {
  if (line == right.line.number) return {1, fmt::format("Right. {}", question.why)};
  return {0, fmt::format("Line {} is the same in both listings. The bug is in line {}. {}", line, right.line.number,
                         question.why)};
}

std::string check_bug(const LessonQuestion& question, Progress& progress, std::string& found) {
  const Document document = state_document(question.state, Document{});
  const std::string bug = bug_of_a(document);
  if (bug.empty()) return "A runs no listing with a bug";
  if (std::string objection = check_sides(document); !objection.empty()) return objection;
  ListingText text;
  int line = 0;
  try {
    text = text_of(bug_named(bug));
    line = bug_line(bug_named(bug)).number;
  } catch (const InputError& error) {
    return error.what();
  }
  if (place_of(text, line) == text.lines.size()) return "the wrong line is not one of those that are shown";
  const Image<Rgb8> a = picture(document, Side::a, progress), b = picture(document, Side::b, progress);
  int differing = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) differing += a.at(x, y) != b.at(x, y) ? 1 : 0;
  found = fmt::format("{}: line {}, {} of {} pixels", bug, line, differing, a.pixels().size());
  if (differing == 0) return "the bug changes no pixel";
  const Vec2i pixel = document.pixel;
  return a.at(pixel.x, pixel.y) != b.at(pixel.x, pixel.y) ? "" : "the bug does not change the picked pixel";
}

std::vector<std::string> bugs_without_step(const Lesson& lesson) {
  std::set<std::string> asked;
  for (const LessonStep& step : lesson.steps)
    if (step.question && step.question->kind == AskKind::bug)
      asked.insert(bug_of_a(state_document(step.question->state, Document{})));
  std::vector<std::string> missing;
  for (const ListingBug& bug : listing_bugs())
    if (bug.folder == lesson.name && !asked.contains(std::string(bug.name))) missing.emplace_back(bug.name);
  return missing;
}

std::vector<ListingLine> function_with_bug(const MeasuredAnswer& bug) {
  const ListingText text = text_of(bug_named(bug.bug));
  const std::size_t at = place_of(text, bug.line.number);
  if (at == text.lines.size()) return {};
  const auto is_outside = [&](std::size_t i) { return text.lines[i].text.empty(); };
  const auto ends = [&](std::size_t i) { return text.lines[i].text.starts_with("}"); };
  std::size_t first = at, last = at;
  // Empty lines are within functions too; only after its end does another one begin.
  while (first > 0 && !(is_outside(first - 1) && (first < 2 || ends(first - 2)))) --first;
  while (last + 1 < text.lines.size() && !ends(last)) ++last;
  return {text.lines.begin() + static_cast<std::ptrdiff_t>(first),
          text.lines.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

}  // namespace ps
