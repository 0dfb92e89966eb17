#include <fmt/format.h>

#include "base/number_text.h"
#include "gui/input/key_hint.h"
#include "gui/panels/lesson/lesson_question.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr std::string_view no_number =
    "This is not a number. Write 0.5 with a point, and 30,000 with or without the comma.";

/// A list of sentences, broken into lines, with a round mark in front of each.
void ask_choice(const LessonQuestion& question, StudentAnswer& answer) {
  const float indent = px(24), width = ImGui::GetContentRegionAvail().x - indent;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const std::string lines = in_lines(question.choices[i].text, width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool chosen = answer.choice == static_cast<int>(i);
    const std::string name = fmt::format("choice/{}", i);
    if (list_row(name, {indent + width, text_height(lines) + px(8)}, false)) answer.choice = static_cast<int>(i);
    controls().record(name, chosen ? "on" : "off");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 middle{at.x + px(11), at.y + px(4) + ImGui::GetFontSize() / 2};
    list.AddCircle(middle, px(6), colour_u32(palette().text), 0, px(1.5));
    if (chosen) list.AddCircleFilled(middle, px(3.5), colour_u32(palette().text));
    draw_lines({at.x + indent, at.y + px(4)}, lines, palette().text);
  }
}

/// Answers whether Enter ended the typing.
bool ask_number(const LessonQuestion& question, LessonQuestions& questions) {
  const float unit = question.unit.empty() ? 0 : text_width(question.unit) + px(8);
  const float width = std::min(px(180), ImGui::GetContentRegionAvail().x - unit);
  const TextEdit edit = text_field("number", questions.typed, "a number", {.width = width});
  if (!question.unit.empty()) {
    ImGui::SameLine(0, px(8));
    ImGui::AlignTextToFramePadding();
    show_text(question.unit);
  }
  const auto number = parse_typed_number(questions.typed);
  if (!number && !questions.typed.empty()) value_paragraph("no-number", no_number);
  questions.answer.number = number.value_or(0);
  return edit.entered && number;
}

void ask_click(const Session& session, LessonQuestions& questions) {
  const auto pixel = session.pixel();
  const bool clicked = pixel && *pixel != questions.pixel_before;
  questions.answer.place = clicked ? *pixel : Vec2i{-1, -1};
  value_paragraph("place", clicked ? fmt::format("You have clicked pixel ({}, {}).", pixel->x, pixel->y)
                                   : "Click the place in a picture; you can click again.");
}

/// How the answer reads; empty as long as there is none.
std::string answer_text(const LessonQuestions& questions) {
  const LessonQuestion& question = *questions.question();
  const StudentAnswer& answer = questions.answer;
  switch (question.kind) {
  case AskKind::choice:
    return answer.choice < 0 ? "" : question.choices.at(static_cast<std::size_t>(answer.choice)).text;
  case AskKind::number:
    if (!parse_typed_number(questions.typed)) return "";
    return question.unit.empty() ? questions.typed : fmt::format("{} {}", questions.typed, question.unit);
  case AskKind::click:
    return answer.place.x < 0 ? "" : fmt::format("pixel ({}, {})", answer.place.x, answer.place.y);
  case AskKind::bug:
    return answer.line < 1 ? "" : fmt::format("line {}", answer.line);
  case AskKind::pixel:
    break;
  }
  return "";
}

/// Why there is no answer to judge yet.
std::string_view missing_answer(const LessonQuestions& questions) {
  switch (questions.question()->kind) {
  case AskKind::choice:
    return "Choose an answer first.";
  case AskKind::number:
    return questions.typed.empty() ? "Type a number first." : no_number;
  case AskKind::click:
    return "Click a pixel of a picture first.";
  case AskKind::bug:
    return "Click a line of the listing first.";
  case AskKind::pixel:
    break;
  }
  return "";
}

void question_text(const LessonQuestion& question) { value_paragraph("text", question.text, {Face::bold}); }

/// Leads from the text to the listing with the line that is asked for, or back.
bool turn_button(AskPlace place, std::string_view label, Emphasis emphasis) {
  const bool text = place == AskPlace::below_text;
  return button(
      "turn", label, emphasis,
      {.tooltip = with_key(text ? "The listing is where you click the line." : "What the step says.", "text-or-tool")});
}

/// A question's controls besides its sentence and its buttons. Answers whether Enter ended the typing of an answer.
bool ask_with_controls(const Session& session, LessonQuestions& questions) {
  const LessonQuestion& question = *questions.question();
  switch (question.kind) {
  case AskKind::choice:
    ask_choice(question, questions.answer);
    return false;
  case AskKind::number:
    return ask_number(question, questions);
  case AskKind::click:
    ask_click(session, questions);
    return false;
  case AskKind::bug:  // the listing is where one clicks
  case AskKind::pixel:
    return false;
  }
  return false;
}

}  // namespace

bool ask_lesson_question(Session& session, LessonQuestions& questions, AskPlace place) {
  const NameScope scope("question");
  const LessonQuestion& question = *questions.question();
  const bool turns = question.kind == AskKind::bug && place != AskPlace::beside_tool;
  bool entered = false;
  if (place != AskPlace::in_line) {
    question_text(question);
    ImGui::Spacing();
    entered = ask_with_controls(session, questions);
    if (!turns) ImGui::Spacing();
  }
  const auto right = questions.right();
  const std::string failure = questions.failure(), given = answer_text(questions);
  const std::string reason = !failure.empty() ? failure
                             : given.empty()  ? std::string(missing_answer(questions))
                             : !right         ? "The answer is being measured."
                                              : "";
  const bool names_line = question.kind == AskKind::bug && !given.empty();
  // In the text there is nothing to answer before the listing was looked at.
  const bool leads_on = turns && place == AskPlace::below_text && given.empty();
  bool turned = leads_on && turn_button(place, "Go to the listing", Emphasis::primary);
  const bool answered =
      !leads_on && button("answer", names_line ? fmt::format("Answer: {}", given) : "Answer", Emphasis::primary,
                          {.tooltip = "Shows whether the answer is right.", .disabled = reason});
  const bool settled = questions.place.settled();
  if (((answered && settled) || entered) && reason.empty()) {
    questions.take(session, given, judge(question, questions.answer, *right));
    return false;
  }
  same_line_if_room(button_width("Skip"));
  if (button("skip", "Skip", Emphasis::quiet, {.tooltip = "Shows the answer and its reason; nothing is kept."}) &&
      settled)
    questions.take(session, "", {});
  if (turns && !leads_on) {
    const std::string_view label = place == AskPlace::below_text ? "Listing" : "Read the task";
    same_line_if_room(button_width(label));
    turned = turn_button(place, label, Emphasis::quiet);
  }
  return turned;
}

void way_back_to_question(Session& session, const LessonQuestions& questions) {
  {
    const NameScope scope("question");
    question_text(*questions.question());
  }
  quiet_text(why_question_waits);
  way_back_button(session);
}

void way_back_button(Session& session) {
  const NameScope scope("question");
  if (button("back", "Back to the question", Emphasis::primary,
             {.tooltip = "Puts this step's pixel and options back."}))
    go_to_step(session, session.document().lesson, session.document().step);
}

void verdict_bar(ImVec2 top, const Judgement& judgement) {
  ImGui::GetWindowDrawList()->AddRectFilled(
      top, {top.x + px(8), ImGui::GetItemRectMax().y},
      colour_u32(judgement.points >= 0.5 ? palette().right_mark : palette().wrong_mark));
}

}  // namespace ps::gui
