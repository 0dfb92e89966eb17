#include "engine/handout_questions.h"

#include <fmt/format.h>

#include "engine/bug_question.h"
#include "engine/handout_page.h"
#include "engine/paper_text.h"
#include "image/svg.h"

namespace ps {
namespace {

/// The function with the wrong line, as students have to read it.
std::string function_html(const LessonQuestion& question) {
  std::string html = "<pre>";
  for (const ListingLine& line : function_with_bug(find_bug(question)))
    html += xml_escaped(fmt::format("{:>4}  {}\n", line.number, line.text));
  return html + "</pre>\n";
}

std::string answer_of_choice(const LessonQuestion& question, Progress& progress) {
  const MeasuredAnswer right = measure_answer(question, progress);
  std::string answer = "No choice is right.", wrong;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const AnswerChoice& choice = question.choices[i];
    if (judge(question, {.choice = static_cast<int>(i)}, right).points > 0)
      answer = fmt::format("{} {}", xml_escaped(choice.text), xml_escaped(choice.feedback));
    else
      wrong += fmt::format("<li><em>{}</em> {}</li>\n", xml_escaped(choice.text), xml_escaped(choice.feedback));
  }
  return fmt::format("{}</p>\n<ul>\n{}</ul>\n<p>{}", answer, wrong, xml_escaped(question.why));
}

std::string answer_words(const LessonQuestion& question, Progress& progress) {
  if (question.kind == AskKind::choice) return answer_of_choice(question, progress);
  if (question.kind == AskKind::bug) {
    const BugLine line = find_bug(question).line;
    return fmt::format("Line {}. {}</p>\n<pre>A: {}\nB: {}</pre>\n<p>", line.number, xml_escaped(question.why),
                       xml_escaped(line.wrong), xml_escaped(line.right));
  }
  std::string found;
  const std::string objection = check_question(question, progress, found);
  if (!objection.empty()) return xml_escaped(objection);
  return xml_escaped(fmt::format("{}{}{}", found, question.why.empty() ? "" : ". ", question.why));
}

}  // namespace

std::string question_html(const LessonQuestion& question, int number, const Document& document) {
  std::string html =
      fmt::format("<div class=\"question{}\"><p><b>Question {}.</b> {}</p>\n",
                  question.kind == AskKind::bug ? " long" : "", number, xml_escaped(question_on_paper(question.text)));
  switch (question.kind) {
  case AskKind::choice:
    html += "<ul>\n";
    for (const AnswerChoice& choice : question.choices)
      html += fmt::format("<li><span class=\"tick\">&#160;</span>{}</li>\n", xml_escaped(choice.text));
    html += "</ul>\n";
    break;
  case AskKind::number:
    html += fmt::format("<p>{} {}</p>\n", write_here, xml_escaped(question.unit));
    break;
  case AskKind::click:
    break;
  case AskKind::bug:
    html += function_html(question) + fmt::format("<p>Line {}</p>\n", write_here);
    break;
  case AskKind::pixel:
    html += fmt::format("<p>Pixel ({}, {}): {}</p>\n", document.pixel.x, document.pixel.y, write_here);
    break;
  }
  return html + "</div>\n";
}

std::string answer_html(const LessonQuestion& question, int number, Progress& progress) {
  return fmt::format("<div class=\"box\"><p><b>Answer {}.</b> {}</p>\n</div>\n", number,
                     answer_words(question, progress));
}

}  // namespace ps
