#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "engine/lesson.h"

namespace ps {

/// One line "word rest" of a fenced block, with its place in the lesson's file.
struct BlockLine {
  std::string word;
  std::string rest;
  SourcePlace place;
};

/// Carries out one line of a `settings` block: scene, set, set-b, set-both, mode, stage, sweep, experiment, `edit PATH
/// VALUE`, and every part of a permalink under its name there, such as camera, pixel, zoom, region, gain, event,
/// vertex. Gives false for any other word; throws InputError for a bad value.
bool read_state_line(const BlockLine& line, LessonState& state);

/// Reads a `claim` block: text, metric, within, bound, mutation, and any line of a `settings` block, which changes the
/// step's state for this claim alone. `start` is the step's state.
Claim read_claim(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place);

/// Reads a `question` block: ask, text, what its kind needs, and any line of a `settings` block, which holds for the
/// measurement alone. `start` is the step's state.
LessonQuestion read_question(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place);

/// Reads a `task` block, a line `write ROUTINE`: a routine of the listing of the lesson of that name.
std::string read_task(const std::vector<BlockLine>& lines, const std::string& lesson, const SourcePlace& place);

/// Whether one of the lines begins with this word.
bool has_line(const std::vector<BlockLine>& lines, std::string_view word);

/// Reads a line `metric` or `within`, in whichever order the two come. Gives false for any other word; throws
/// InputError for what is not a metric or not a rectangle.
bool read_metric_line(const BlockLine& line, Metric& metric);

/// Throws InputError for a rectangle of a metric that is not measured on one.
void require_within(const Metric& metric);

/// Runs `read()`; an InputError without a place is thrown again with the line's in front of its message.
template <class Read>
void at_place(const SourcePlace& place, Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    if (error.place().line > 0) throw;
    throw InputError(fmt::format("{}:{}: {}", place.file, place.line, error.what()));
  }
}

}  // namespace ps
