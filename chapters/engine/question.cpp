#include "engine/question.h"

#include <fmt/format.h>

#include "base/number_text.h"
#include "engine/block.h"

namespace ps {
namespace {

constexpr std::string_view kinds = "choice, number, click, bug, colour, winner, rays, triangle or tests";

void read_ask(const std::string& text, LessonQuestion& question) {
  if (text == "choice")
    question.kind = AskKind::choice;
  else if (text == "number")
    question.kind = AskKind::number;
  else if (text == "click")
    question.kind = AskKind::click;
  else if (text == "bug")
    question.kind = AskKind::bug;
  else {
    question.kind = AskKind::pixel;
    try {
      question.about = parse_question(text);
    } catch (const InputError&) {
      throw InputError(fmt::format("ask: found '{}', expected {}", text, kinds));
    }
  }
}

/// ">= 100: The answer. | What is wrong about it."
AnswerChoice read_choice(const std::string& text) {
  const auto colon = text.find(": ");
  if (colon == std::string::npos)
    throw InputError(fmt::format("choice: found '{}', expected 'BOUND: ANSWER | SENTENCE'", text));
  AnswerChoice choice;
  choice.bound = parse_bound(text.substr(0, colon));
  choice.text = text.substr(colon + 2);
  if (const auto bar = choice.text.find(" | "); bar != std::string::npos) {
    choice.feedback = choice.text.substr(bar + 3);
    choice.text.resize(bar);
  }
  return choice;
}

void read_hidden(const std::string& text, LessonQuestion& question) {
  if (text != "a" && text != "b" && text != "both")
    throw InputError(fmt::format("hide: found '{}', expected a, b or both", text));
  question.hidden = {text != "b", text != "a"};
}

double read_tolerance(const std::string& text) {
  const auto number = parse_number(text);
  if (!number || *number < 0) throw InputError(fmt::format("tolerance: found '{}', expected a number from 0", text));
  return *number;
}

void read_question_line(const BlockLine& line, LessonQuestion& question) {
  if (read_metric_line(line, question.metric)) return;
  const std::string& rest = line.rest;
  if (line.word == "ask")
    read_ask(rest, question);
  else if (line.word == "text")
    question.text = rest;
  else if (line.word == "choice")
    question.choices.push_back(read_choice(rest));
  else if (line.word == "bound")
    question.bound = parse_bound(rest);
  else if (line.word == "tolerance")
    question.tolerance = read_tolerance(rest);
  else if (line.word == "unit")
    question.unit = rest;
  else if (line.word == "why")
    question.why = rest;
  else if (line.word == "hide")
    read_hidden(rest, question);
  else if (!read_state_line(line, question.state))
    throw InputError(
        line.place, fmt::format("'{} {}'", line.word, rest),
        "ask, text, metric, within, choice, bound, tolerance, unit, why, hide or a line of a settings block");
}

/// The lines that a kind must have, and those that only it may have.
void require_complete(const LessonQuestion& question, const std::vector<BlockLine>& lines, const SourcePlace& place) {
  if (!has_line(lines, "ask"))
    throw InputError(place, "a question about nothing", fmt::format("a line 'ask' with {}", kinds));
  if (question.text.empty()) throw InputError(place, "a question without words", "a line 'text QUESTION'");
  const auto require = [&](std::string_view word, bool wanted) {
    if (has_line(lines, word) == wanted) return;
    throw InputError(
        place,
        fmt::format("a question with 'ask {}' {} a line '{}'", ask_text(question), wanted ? "without" : "with", word),
        wanted ? "one" : "none");
  };
  const bool is_bug = question.kind == AskKind::bug;
  require("metric", question.kind != AskKind::pixel && !is_bug);
  require("choice", question.kind == AskKind::choice);
  require("bound", question.kind == AskKind::click);
  if (question.kind != AskKind::number) require("tolerance", false);
  if (is_bug) require("why", true);
  if (is_bug) require("hide", false);  // both pictures are hints
  if (question.choices.size() == 1) throw InputError(place, "a single choice", "two or more");
}

}  // namespace

std::string_view ask_text(const LessonQuestion& question) {
  switch (question.kind) {
  case AskKind::choice:
    return "choice";
  case AskKind::number:
    return "number";
  case AskKind::click:
    return "click";
  case AskKind::bug:
    return "bug";
  case AskKind::pixel:
    return question_key(question.about);
  }
  return "";
}

LessonQuestion read_question(const std::vector<BlockLine>& lines, const LessonState& start, const SourcePlace& place) {
  LessonQuestion question;
  question.state = start;
  for (const BlockLine& line : lines) at_place(line.place, [&] { read_question_line(line, question); });
  require_complete(question, lines, place);
  at_place(place, [&] { require_within(question.metric); });
  return question;
}

}  // namespace ps
