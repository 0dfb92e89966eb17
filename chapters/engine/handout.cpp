#include "engine/handout.h"

#include <set>
#include <utility>

#include <fmt/format.h>

#include "engine/claim.h"
#include "engine/glossary.h"
#include "engine/handout_page.h"
#include "engine/handout_pictures.h"
#include "engine/handout_questions.h"
#include "engine/lesson_length.h"
#include "engine/measured_pictures.h"
#include "engine/metric_words.h"
#include "engine/paper_text.h"
#include "image/svg.h"
#include "render/provenance.h"

namespace ps {
namespace {

std::string box(const std::string& title, const std::string& body) {
  return fmt::format("<div class=\"box\"><p><b>{}</b></p>\n{}</div>\n", title, body);
}

/// The sentences that the lesson measures, with what was measured just now.
std::string claims_html(const std::vector<Claim>& claims, MeasuredPictures& pictures, Progress& progress) {
  if (claims.empty()) return {};
  std::string html = "<table><tr><th>Claim</th><th>Measured</th></tr>\n";
  for (const Claim& claim : claims) {
    const double value = measure(claim.metric, claim_document(claim, pictures.last()), progress, &pictures);
    html += fmt::format("<tr><td>{}</td><td>{}: {}</td></tr>\n", xml_escaped(claim.text),
                        xml_escaped(metric_words(claim.metric)), value_words(claim.metric, value));
  }
  return html + "</table>\n";
}

/// The minutes of each step, and from the start. The whole is as long as the lesson says.
std::string time_plan(const Lesson& lesson) {
  std::string html = "<table><tr><th>Step</th><th>Minutes</th><th>Together</th></tr>\n";
  Lesson so_far;
  so_far.blocks = lesson.blocks;
  int before = 0;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    so_far.steps.push_back(lesson.steps[i]);
    const int minutes = length_of(so_far).minutes();
    html += fmt::format("<tr><td>{}. {}</td><td>{}</td><td>{}</td></tr>\n", i + 1, xml_escaped(lesson.steps[i].title),
                        minutes - std::exchange(before, minutes), minutes);
  }
  return html + "</table>\n";
}

/// The terms of the glossary that the lesson names, with their meaning.
std::string terms_html(const Lesson& lesson) {
  std::set<std::string> named;
  for (const LessonStep& step : lesson.steps)
    for (const auto* blocks : {&step.blocks, &step.hints})
      for (const TextBlock& block : *blocks)
        for (const TextSpan& span : block.spans)
          if (span.link.kind == LinkKind::term) named.insert(span.link.target);
  std::string html;
  for (const std::string& name : named)
    if (const GlossaryEntry* entry = find_entry(name))
      html += fmt::format("<p><b>{}</b></p>\n{}", xml_escaped(entry->term), block_html({entry->definition}));
  return html.empty() ? "" : box("Words", html);
}

std::string head_html(const Lesson& lesson, HandoutFor reader) {
  std::string html = fmt::format(
      "<h1>{}</h1>\n<p class=\"source\">{}; about {} minutes; in the program: <code>pixelscope "
      "--lesson {}</code></p>\n",
      xml_escaped(lesson.title), xml_escaped(lesson.source), length_of(lesson).minutes(), xml_escaped(lesson.name));
  if (reader == HandoutFor::student) html += "<p class=\"person\"><span>Name</span><span>Date</span></p>\n";
  html += block_html(on_paper(lesson.blocks));
  if (!lesson.goals.empty()) html += box("Afterwards you can", list_html(lesson.goals));
  if (reader == HandoutFor::teacher) {
    if (!lesson.notes.empty()) html += box("For the teacher", block_html(lesson.notes));
    html += time_plan(lesson);
  }
  return html;
}

/// For the teacher: what the class sees after this step, so that a question can lead to it.
std::string next_html(const Lesson& lesson, std::size_t step) {
  const std::string title = step + 1 < lesson.steps.size()
                                ? fmt::format("{}. {}", step + 2, lesson.steps[step + 1].title)
                                : "the end of the lesson";
  return fmt::format("<p class=\"next\"><b>Next:</b> {}</p>\n", xml_escaped(title));
}

/// For the teacher: the program, and the computer that has measured.
std::string facts() {
  std::string text;
  for (const auto& [key, value] : provenance_facts(provenance_of(Settings{})))
    if (!value.empty()) text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", xml_escaped(key), xml_escaped(value));
  return text;
}

}  // namespace

std::string handout_html(const Lesson& lesson, HandoutFor reader, Progress& progress) {
  const bool teacher = reader == HandoutFor::teacher;
  std::string body = head_html(lesson, reader);
  MeasuredPictures pictures;  // a step's claims mostly measure the same ones
  int questions = 0;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& step = lesson.steps[i];
    const Document document = lesson_document(lesson, static_cast<int>(i), Document{});
    body += fmt::format("<section id=\"step-{0}\"{4}><h2><span class=\"place\">{2}/{0}</span>{0}. {1}</h2>\n{3}", i + 1,
                        xml_escaped(step.title), xml_escaped(lesson.name), block_html(on_paper(step.blocks)),
                        teacher ? " class=\"page\"" : "");
    if (teacher && !step.notes.empty()) body += box("For the teacher", block_html(step.notes));
    body +=
        pictures_html(document, !teacher && step.question ? step.question->hidden : std::array{false, false}, progress);
    if (step.question) {
      body += question_html(*step.question, ++questions, document);
      if (teacher) body += answer_html(*step.question, questions, progress);
    }
    if (const auto hints = hints_on_paper(step.hints); !hints.empty())
      body += fmt::format("<div class=\"look\">{}</div>\n", block_html(hints));
    if (teacher) {
      body += claims_html(step.claims, pictures, progress);
      body += next_html(lesson, i);
    }
    body += "</section>\n";
  }
  body += terms_html(lesson);
  return handout_page(lesson.title, body, teacher ? facts() : "");
}

}  // namespace ps
