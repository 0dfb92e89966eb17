#include "gui/panels/story/lesson_question.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/answers.h"
#include "engine/lesson.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

std::string key_of(const std::string& lesson, int step) { return fmt::format("{}/{}", lesson, step); }

/// A list of sentences, broken into lines, with a round mark in front of each.
void ask_choice(const LessonQuestion& question, StudentAnswer& answer) {
  const float indent = px(24), width = ImGui::GetContentRegionAvail().x - indent;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const std::string lines = in_lines(question.choices[i].text, width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = text_height(lines) + px(8);
    const bool chosen = answer.choice == static_cast<int>(i);
    if (hit_area(fmt::format("choice/{}", i), {indent + width, height}, {})) answer.choice = static_cast<int>(i);
    const bool hovered = ImGui::IsItemHovered();
    controls().record(fmt::format("choice/{}", i), chosen ? "on" : "off");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + indent + width, at.y + height};
    if (hovered) list.AddRectFilled(at, end, colour_u32(palette().field_hover), px(3));
    const ImVec2 middle{at.x + px(11), at.y + px(4) + ImGui::GetFontSize() / 2};
    list.AddCircle(middle, px(6), colour_u32(palette().text), 0, px(1.5));
    if (chosen) list.AddCircleFilled(middle, px(3.5), colour_u32(palette().text));
    draw_lines({at.x + indent, at.y + px(4)}, lines, palette().text);
  }
}

void ask_number(const LessonQuestion& question, StudentAnswer& answer) {
  // Whole steps suit most answers; finer ones are typed.
  const double reach = 1e6;
  number("number", answer.number, {.minimum = -reach, .maximum = reach, .unit = question.unit}, {.width = px(180)});
}

void ask_click(const Session& session, LessonQuestions& questions) {
  const auto pixel = session.pixel();
  const bool clicked = pixel && *pixel != questions.pixel_before;
  questions.answer.place = clicked ? *pixel : Vec2i{-1, -1};
  value_paragraph("place",
                  clicked ? fmt::format("Pixel ({}, {}).", pixel->x, pixel->y) : "Click a pixel in a picture.");
}

/// Whether something was answered, and how it reads.
std::string answer_text(const LessonQuestion& question, const StudentAnswer& answer) {
  switch (question.kind) {
  case AskKind::choice:
    return answer.choice < 0 ? "" : question.choices.at(static_cast<std::size_t>(answer.choice)).text;
  case AskKind::number:
    return short_number(answer.number);
  case AskKind::click:
    return answer.place.x < 0 ? "" : fmt::format("pixel {},{}", answer.place.x, answer.place.y);
  case AskKind::pixel:
    break;
  }
  return "";
}

}  // namespace

LessonQuestions::LessonQuestions(const std::function<void()>& wake, bool remember)
    : remember_(remember), measuring_(wake) {
  if (!remember_) return;
  try {
    for (const GivenAnswer& each : kept_answers(answers_file()))
      answered_[key_of(each.lesson, each.step)] = {each.points, fmt::format("You answered: {}.", each.answer)};
  } catch (const InputError&) {
    remember_ = false;  // what is there is left as it is; the command line shows what is wrong with it
  }
}

const Judgement* LessonQuestions::verdict() const {
  const auto found = answered_.find(here_);
  return question_ && found != answered_.end() ? &found->second : nullptr;
}

bool LessonQuestions::follow(Session& session) {
  const Document& document = session.document();
  const std::string here = document.lesson.empty() ? "" : key_of(document.lesson, document.step);
  if (here == here_) return false;
  here_ = here;
  question_.reset();
  measuring_.cancel();
  answer = {};
  pixel_before = document.pixel;
  if (here.empty()) return true;
  try {
    const Lesson lesson = load_lesson(document.lesson);
    if (static_cast<std::size_t>(document.step) < lesson.steps.size())
      question_ = lesson.steps[static_cast<std::size_t>(document.step)].question;
  } catch (const InputError&) {
    // The lesson's own panel says what is wrong with it.
  }
  if (question_ && question_->kind != AskKind::pixel)
    measuring_.start([question = *question_](StudyControl& control, const auto& publish) {
      publish(std::make_shared<const MeasuredAnswer>(measure_answer(question, control.progress())), {});
    });
  return true;
}

void LessonQuestions::take(Session& session, const std::string& given, const Judgement& judgement) {
  answered_[here_] = judgement;
  const Document& document = session.document();
  if (!remember_ || !question_ || given.empty()) return;
  try {
    keep_answer(answers_file(),
                {answer_time(), document.lesson, document.step, question_->text, given, judgement.points});
  } catch (const InputError& error) {
    session.say(Message::Kind::warning, fmt::format("The answer is not kept: {}", error.what()));
    remember_ = false;
  }
}

void ask_lesson_question(Session& session, LessonQuestions& questions) {
  const NameScope scope("question");
  const LessonQuestion& question = *questions.question();
  {
    const FontScope font(Face::bold);
    value_paragraph("text", question.text);
  }
  ImGui::Spacing();
  switch (question.kind) {
  case AskKind::choice:
    ask_choice(question, questions.answer);
    break;
  case AskKind::number:
    ask_number(question, questions.answer);
    break;
  case AskKind::click:
    ask_click(session, questions);
    break;
  case AskKind::pixel:
    break;
  }
  ImGui::Spacing();
  const auto right = questions.right();
  const std::string failure = questions.failure(), given = answer_text(question, questions.answer);
  const std::string reason = !failure.empty() ? failure
                             : !right         ? "The answer is being measured."
                             : given.empty()  ? "Choose an answer first."
                                              : "";
  if (button("answer", "Answer", Emphasis::primary,
             {.tooltip = "Shows whether the answer is right.", .disabled = reason}))
    questions.take(session, given, judge(question, questions.answer, *right));
  same_line_if_room(button_width("Show me"));
  if (button("skip", "Show me", Emphasis::quiet,
             {.tooltip = "Goes on without an answer; nothing is counted.", .disabled = {}}))
    questions.take(session, "", {});
}

void lesson_verdict(LessonQuestions& questions) {
  const Judgement* verdict = questions.verdict();
  if (!verdict) return;
  const NameScope scope("question");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Indent(px(16));
  value_paragraph("verdict", verdict->sentence.empty() ? "Not answered." : verdict->sentence);
  ImGui::Unindent(px(16));
  if (!verdict->sentence.empty())
    ImGui::GetWindowDrawList()->AddRectFilled(
        at, {at.x + px(8), ImGui::GetItemRectMax().y},
        colour_u32(verdict->points >= 0.5 ? palette().right_mark : palette().wrong_mark));
  if (button("again", "Ask again", Emphasis::quiet, {.tooltip = "The question is open again.", .disabled = {}}))
    questions.ask_again();
}

}  // namespace ps::gui
