#include "gui/panels/lesson/caption_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/paper_text.h"
#include "gui/input/key_hint.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/screen_painter.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr float lines_of_page = 3;

/// Without links and controls, which are not for an audience.
TextBlock spoken(TextBlock block) {
  for (TextSpan& span : block.spans) {
    span.style = TextStyle::plain;
    span.link = {};
  }
  return block;
}

TextBlock words_block(const std::string& text) {
  TextBlock block;
  block.spans.push_back({text, TextStyle::plain, {}, {}});
  return block;
}

std::string words_of_line(const TextLine& line) {
  std::string words = line.mark;
  const TextSpan* formula = nullptr;  // whose words are there already
  float end = 0;
  for (const TextPiece& piece : line.pieces) {
    const bool apart = piece.x > end + 1;
    end = piece.x + piece.width;
    if (piece.formula && piece.span == formula) continue;
    if (!words.empty() && apart) words += ' ';
    words += piece.formula ? std::string_view(piece.span->text) : piece.text;
    formula = piece.formula ? piece.span : nullptr;
  }
  return words;
}

}  // namespace

void draw_projected_figure(const Figure& figure) {
  ScreenPainter painter(*ImGui::GetWindowDrawList(), {}, PaintedType::projected);
  const ImVec2 from = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  float width = room.x;
  const auto height_at = [&] { return static_cast<float>(figure_height(painter, figure, width)); };
  while (width > px(200) && height_at() > room.y) width *= 0.95f;
  const ImVec2 at{from.x + (room.x - width) / 2, from.y + std::max(0.f, (room.y - height_at()) / 2)};
  draw_figure(painter, figure, paint_place(at), width);
  controls().record("figure", at, {at.x + width, at.y + height_at()}, figure_words(figure));
}

CaptionStrip::CaptionStrip(const Session& session, LessonReading& state, float width)
    : state_(state), lesson_(state.shelf.open()), width_(width) {
  if (!lesson_ || lesson_->steps.empty()) {
    lesson_ = nullptr;
    return;
  }
  step_ = std::clamp(session.document().step, 0, static_cast<int>(lesson_->steps.size()) - 1);
  const LessonStep& step = lesson_->steps[static_cast<std::size_t>(step_)];
  for (const TextBlock& block : step.blocks) add_text(block, mark_of(block));
  if (step.question && state.questions.open()) {
    add_question(*step.question);
  } else {
    if (step.question) {
      pages_.emplace_back();  // in the question's place
      add_text(words_block(told_answer(state.questions)), {});
    }
    for (const TextBlock& hint : step.hints) add_text(hint, "→");
  }
  if (pages_.empty()) pages_.emplace_back();
  ReadPage& caption = state.caption;
  follow_step(session, caption);
  caption.pages = static_cast<int>(pages_.size());
  caption.page = std::clamp(caption.page, 0, caption.pages - 1);
  caption.asks = pages_[static_cast<std::size_t>(caption.page)].asks;
  const auto story = state.holds_back ? nullptr : session.story(session.document().picked);
  for (const Part& part : pages_[static_cast<std::size_t>(caption.page)].parts)
    if (part.block.figure && !figure_) figure_ = figure_of_pixel(part.block.figure, story.get());
}

std::vector<TextLine> CaptionStrip::lines_of(const Page& page) const {
  const FontScope font(Face::caption);
  std::vector<TextLine> lines;
  for (const Part& part : page.parts) lay_out(part.block, part.mark, Face::caption, width_, lines);
  return lines;
}

float CaptionStrip::height_of(const Page& page) const {
  float height = 0;
  for (const TextLine& line : lines_of(page)) height += line.height;
  return height;
}

/// Sentence by sentence: what is full ends with one. A sentence with more lines than others has a page for itself.
void CaptionStrip::add_text(const TextBlock& block, const std::string& mark) {
  const float most = lines_of_page * text_line_height(Face::caption);
  bool begins = true;  // the block
  Part part{spoken(block), mark};
  for (Sentence& sentence : sentences_of(part.block)) {
    Page longer = pages_.empty() ? Page{} : pages_.back();
    part.block.spans = std::move(sentence);
    if (begins || longer.parts.empty()) {
      longer.parts.push_back(part);
    } else {
      auto& spans = longer.parts.back().block.spans;
      spans.insert(spans.end(), part.block.spans.begin(), part.block.spans.end());
    }
    if (pages_.empty() || pages_.back().asks || height_of(longer) > most)
      pages_.push_back({{part}, false});
    else
      pages_.back() = std::move(longer);
    begins = false;
    part.mark.clear();
  }
}

void CaptionStrip::add_question(const LessonQuestion& question) {
  Page& page = pages_.emplace_back(Page{{{words_block(question.text), ""}}, true});
  for (std::size_t i = 0; i < question.choices.size(); ++i)
    page.parts.push_back({words_block(question.choices[i].text), fmt::format("{}.", i + 1)});
}

float CaptionStrip::height() const {
  if (!lesson_) return 0;
  const float text = height_of(pages_[static_cast<std::size_t>(state_.caption.page)]);
  return std::max(text, lines_of_page * text_line_height(Face::caption)) + text_line_height(Face::caption) + px(24);
}

void CaptionStrip::draw(Session& session) {
  if (!lesson_) return;
  const NameScope scope("caption");
  ReadPage& caption = state_.caption;
  caption.seen.now();
  const FontScope font(Face::caption);
  value_text("place",
             fmt::format("{}   {} of {}, page {} of {}{}", lesson_->steps[static_cast<std::size_t>(step_)].title,
                         step_ + 1, lesson_->steps.size(), caption.page + 1, caption.pages,
                         caption.asks ? with_key("   reveal the answer", "lesson-read-on") : ""));
  note_read(state_, *lesson_, step_, caption);
  ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 from = at;
  std::string shown;
  for (const TextLine& line : lines_of(pages_[static_cast<std::size_t>(caption.page)])) {
    ImGui::SetCursorScreenPos(at);
    draw_line(session, line);
    at.y += line.height;
    shown += (shown.empty() ? "" : "\n") + words_of_line(line);
  }
  controls().record("text", from, {from.x + width_, at.y}, shown);
}

}  // namespace ps::gui
