#include "engine/handout.h"

#include <fmt/format.h>

#include "document/permalink.h"
#include "engine/bug_question.h"
#include "engine/lesson_length.h"
#include "engine/metric_words.h"
#include "frame/display_frame.h"
#include "image/codec.h"
#include "image/file.h"
#include "image/svg.h"
#include "render/provenance.h"
#include "render/render.h"
#include "render/slow_motion.h"

namespace ps {
namespace {

constexpr std::string_view style_sheet =
    "body{font:16px/1.5 Georgia,serif;max-width:46em;margin:2em auto;padding:0 1em;color:#111}"
    "h1,h2,h3,figcaption,table,.question{font-family:Helvetica,Arial,sans-serif}"
    ".source,figcaption,footer,.link{color:#555;font-size:85%}"
    ".pictures{display:flex;gap:1em;margin:1em 0}figure{flex:1;margin:0;min-width:0}"
    "img{width:100%;box-sizing:border-box;border:1px solid #bbb;image-rendering:pixelated}.covered{border:1px solid "
    "#999;padding:30% 1em;text-align:center}"
    ".look{border-left:3px solid #999;padding-left:1em}"
    ".notes{background:#eee;padding:.2em 1em;margin:1em 0;font-size:90%}"
    "table{border-collapse:collapse;font-size:85%;width:100%}td,th{border:1px solid #bbb;padding:.3em .5em;"
    "text-align:left;vertical-align:top}.question{border:1px solid #555;padding:.5em 1em;margin:1em 0}"
    "pre{font:80%/1.35 monospace;white-space:pre-wrap;overflow-wrap:anywhere}"
    ".write{border-bottom:1px solid #111;display:inline-block;width:12em}code{overflow-wrap:anywhere}"
    "@media print{body{margin:0;max-width:none}section,.question,figure,tr{break-inside:avoid}}";

std::string page(const std::string& title, const std::string& body) {
  std::string facts;
  for (const auto& [key, value] : provenance_facts(provenance_of(Settings{})))
    if (!value.empty())
      facts += fmt::format("{}{}: {}", facts.empty() ? "" : "; ", xml_escaped(key), xml_escaped(value));
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\"><head><meta charset=\"utf-8\"/>"
      "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>{}</title>\n<style>{}</style></head>\n<body>\n"
      "{}<footer><p>{}</p></footer>\n</body></html>\n",
      xml_escaped(title), style_sheet, body, facts);
}

Image<Rgb8> picture_of(const Document& document, Side side, Prepared& prepared, Progress& progress) {
  if (side == Side::b && !document.picture_b.empty()) return load_levels(document.picture_b);
  const SideState& state = side_of(document, side);
  RenderRequest request;
  request.channels = shown_channel(state.show).needs;
  request.region = document.view.region;
  const View view = view_of(document);
  const auto slow = given_slow_motion(state.slow_motion, state.settings, scene_traits(document.scene), state.show);
  const Frame frame =
      slow ? render_slowly(document.scene, view, state.settings, *slow, request, prepared, progress).frame
           : render(document.scene, view, state.settings, request, prepared, progress);
  if (state.show == ShownChannel::colour) return display_frame(frame, state.settings);
  return channel_picture(frame, state.show, state.settings).levels;
}

std::string figure(const Image<Rgb8>& levels, std::string_view letter, const SideState& side) {
  std::string caption = side.show == ShownChannel::colour
                            ? std::string(letter)
                            : fmt::format("{}: {}", letter, shown_channel(side.show).label);
  if (const auto& slow = side.slow_motion)
    caption += fmt::format(", after {} {}", slow->at, slow_unit(slow->unit).many);
  return fmt::format("<figure><img alt=\"picture {}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\"/>"
                     "<figcaption>{}</figcaption></figure>\n",
                     letter, levels.width(), levels.height(), base64(stb_encode_png(levels)), xml_escaped(caption));
}

std::string pictures(const Document& document, const std::array<bool, 2>& covered, Progress& progress) {
  Prepared prepared;
  std::string html = "<div class=\"pictures\">\n";
  for (const Side side : {Side::a, Side::b}) {
    if (document.compare == (side == Side::a ? CompareMode::only_b : CompareMode::only_a)) continue;
    const std::string_view letter = side == Side::a ? "A" : "B";
    if (covered[side == Side::a ? 0 : 1])
      html += fmt::format("<figure><div class=\"covered\">{} is shown in the program after your answer.</div>"
                          "<figcaption>{}</figcaption></figure>\n",
                          letter, letter);
    else
      html += figure(picture_of(document, side, prepared, progress), letter, side_of(document, side));
  }
  return html + "</div>\n";
}

std::string claims(const std::vector<Claim>& claims, Progress& progress) {
  if (claims.empty()) return {};
  std::string html = "<table><tr><th>Claim</th><th>Measured</th><th>Claimed</th><th>Does not hold with</th></tr>\n";
  for (const Claim& claim : claims) {
    const ClaimResult result = check_claim(claim, progress);
    html += fmt::format("<tr><td>{}</td><td>{}: {}</td><td>{}</td><td>{}: {}</td></tr>\n", xml_escaped(claim.text),
                        xml_escaped(metric_words(claim.metric)), value_words(claim.metric, result.value),
                        xml_escaped(demand_words(claim.metric, claim.bound)), xml_escaped(claim.mutation.words),
                        value_words(claim.mutation.metric, result.mutated_value));
  }
  return html + "</table>\n";
}

/// The function with the wrong line, as students have to read it.
std::string function_html(const LessonQuestion& question) {
  std::string html = "<pre>";
  for (const ListingLine& line : function_with_bug(find_bug(question)))
    html += xml_escaped(fmt::format("{:>4}  {}\n", line.number, line.text));
  return html + "</pre>\n";
}

/// With room for the answer.
std::string question_html(const LessonQuestion& question, int number, const Document& document) {
  std::string html =
      fmt::format("<div class=\"question\"><p><b>Question {}.</b> {}</p>\n", number, xml_escaped(question.text));
  constexpr std::string_view line = "<span class=\"write\">&#160;</span>";
  switch (question.kind) {
  case AskKind::choice:
    html += "<ul>\n";
    for (const AnswerChoice& choice : question.choices) html += fmt::format("<li>{}</li>\n", xml_escaped(choice.text));
    html += "</ul>\n";
    break;
  case AskKind::number:
    html += fmt::format("<p>{} {}</p>\n", line, xml_escaped(question.unit));
    break;
  case AskKind::click:
    html += "<p>Mark the place in a picture.</p>\n";
    break;
  case AskKind::bug:
    html += function_html(question) + fmt::format("<p>Line {}</p>\n", line);
    break;
  case AskKind::pixel:
    html += fmt::format("<p>Pixel ({}, {}): {}</p>\n", document.pixel.x, document.pixel.y, line);
    break;
  }
  return html + "</div>\n";
}

/// For teachers alone.
std::string notes_html(const std::vector<TextBlock>& notes, HandoutFor reader) {
  if (notes.empty() || reader != HandoutFor::teacher) return {};
  return fmt::format("<div class=\"notes\"><p><b>For the teacher</b></p>\n{}</div>\n", block_html(notes));
}

std::string answer_of(const LessonQuestion& question, Progress& progress) {
  if (question.kind == AskKind::choice) {
    const MeasuredAnswer right = measure_answer(question, progress);
    for (std::size_t i = 0; i < question.choices.size(); ++i)
      if (const Judgement judgement = judge(question, {.choice = static_cast<int>(i)}, right); judgement.points > 0)
        return question.choices[i].text + " " + judgement.sentence;
    return "No choice is right.";
  }
  if (question.kind == AskKind::bug) {
    const BugLine line = find_bug(question).line;
    return fmt::format("Line {}. A: {} B: {} {}", line.number, line.wrong, line.right, question.why);
  }
  std::string found;
  const std::string objection = check_question(question, progress, found);
  return objection.empty() ? fmt::format("{}{}{}", found, question.why.empty() ? "" : ". ", question.why) : objection;
}

}  // namespace

std::string handout_html(const Lesson& lesson, HandoutFor reader, Progress& progress) {
  std::string body = fmt::format("<h1>{}</h1>\n<p class=\"source\">{}</p>\n{}", xml_escaped(lesson.title),
                                 xml_escaped(lesson.source), block_html(lesson.blocks));
  body += notes_html(lesson.notes, reader);
  std::string answers;
  int questions = 0;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const Document document = lesson_document(lesson, static_cast<int>(i), Document{});
    const bool covers = reader == HandoutFor::student && step.question;
    body += fmt::format("<section id=\"step-{}\"><h2>{}. {}</h2>\n{}", i + 1, i + 1, xml_escaped(step.title),
                        block_html(step.blocks));
    body += notes_html(step.notes, reader);
    body += pictures(document, covers ? step.question->hidden : std::array{false, false}, progress);
    if (step.question) {
      body += question_html(*step.question, ++questions, document);
      if (reader == HandoutFor::teacher)
        answers += fmt::format("<p><b>{}.</b> {}</p>\n", questions, xml_escaped(answer_of(*step.question, progress)));
    }
    if (!step.hints.empty()) body += fmt::format("<div class=\"look\">{}</div>\n", block_html(step.hints));
    body += claims(step.claims, progress);
    body += fmt::format("<p class=\"link\">In the program: <code>pixelscope --permalink '{}'</code></p></section>\n",
                        xml_escaped(permalink(document)));
  }
  if (!answers.empty()) body += "<section><h2>Answers</h2>\n" + answers + "</section>\n";
  return page(lesson.title, body);
}

std::string handout_index(const std::vector<Lesson>& lessons) {
  std::string body = "<h1>Lessons</h1>\n<ul>\n";
  for (const Lesson& lesson : lessons)
    body += fmt::format("<li><a href=\"{}.html\">{}</a> <span class=\"source\">{}; {} steps, {} minutes</span></li>\n",
                        xml_escaped(lesson.name), xml_escaped(lesson.title), xml_escaped(lesson.source),
                        lesson.steps.size(), length_of(lesson).minutes());
  return page("Lessons", body + "</ul>\n");
}

}  // namespace ps
