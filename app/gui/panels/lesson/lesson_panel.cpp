#include "gui/panels/lesson/lesson_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <sstream>
#include <utility>
#include <vector>

#include "engine/figure.h"
#include "gui/base/region_names.h"
#include "gui/panels/lesson/claim_view.h"
#include "gui/panels/lesson/step_options.h"
#include "gui/panels/lesson/text_needs.h"
#include "gui/panels/lesson/text_pages.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/flash.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr const char* read_lessons_key = "app/read-lessons";

/// From lines of a name each.
std::set<std::string> parse_read_lessons(const std::string& lines) {
  std::set<std::string> names;
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);)
    if (!line.empty()) names.insert(line);
  return names;
}

TextBlock block_of(BlockKind kind, const std::string& text) {
  TextBlock block;
  block.kind = kind;
  block.spans.push_back({text, TextStyle::plain, {}});
  return block;
}

/// The blocks that only this file makes; they live as long as the lines that point into them.
struct OwnBlocks {
  TextBlock source, title;
  TextBlock question, verdict;     ///< once it was answered
  std::vector<TextBlock> options;  ///< what the step is about, with controls
  TextBlock claims_title;
  std::vector<TextBlock> claims;  ///< the sentences that are measured; none while a question is open
  std::vector<ClaimLayout> measured;
  std::list<TextBlock> drawn;  ///< the figures, for the picked pixel
};

/// The question with what is said of its answer, and a button to be asked again.
void lay_out_verdict(const OwnBlocks& own, const StepVerdict& verdict, float width, std::vector<TextLine>& lines) {
  const std::size_t first = lines.size();
  lay_out(own.question, {}, Face::bold, width, lines);
  const std::size_t judged = lines.size();
  lay_out(own.verdict, " ", Face::body, width, lines);
  if (verdict.points)
    for (std::size_t line = judged; line < lines.size(); ++line) lines[line].judged = *verdict.points >= 0.5;
  for (std::size_t line = first; line < lines.size(); ++line) lines[line].stays_with_next = true;
  TextLine again;
  again.gap = px(2);
  again.height = ImGui::GetFrameHeight();
  again.asks_again = true;
  lines.push_back(std::move(again));
}

/// The lines of the claims, each with what is measured below it.
void lay_out_claims(OwnBlocks& own, const LessonClaims& claims, float width, std::vector<TextLine>& lines) {
  if (own.claims.empty()) return;
  lay_out(own.claims_title, {}, Face::body, width, lines);
  for (std::size_t i = 0; i < own.claims.size(); ++i) {
    const std::size_t first = lines.size();
    lay_out(own.claims[i], {}, Face::body, width, lines);
    for (std::size_t line = first; line < lines.size(); ++line) lines[line].stays_with_next = true;
    TextLine measured;
    measured.gap = px(1);
    measured.height = own.measured.emplace_back(lay_out_claim(claims, i, width)).height;
    measured.claim = i;
    lines.push_back(std::move(measured));
  }
}

OwnBlocks own_blocks(const Session& session, const LessonReading& state, const Lesson& lesson, const LessonStep& step) {
  OwnBlocks own{block_of(BlockKind::paragraph, lesson.source),
                block_of(BlockKind::paragraph, step.title),
                {},
                {},
                {},
                block_of(BlockKind::heading, "Measured"),
                {},
                {},
                {}};
  if (state.verdict) {
    own.question = block_of(BlockKind::paragraph, state.verdict->question);
    own.verdict = block_of(BlockKind::paragraph, state.verdict->sentence);
  }
  if (!state.holds_back)
    for (const Claim& claim : state.claims.claims()) own.claims.push_back(block_of(BlockKind::paragraph, claim.text));
  if (session.document().mode == ScreenMode::explore) return own;  // they are below in the options panel
  for (const Option* option : step_options(step)) {
    TextBlock& block = own.options.emplace_back(block_of(BlockKind::paragraph, std::string(option->label) + " "));
    block.spans.push_back({{}, TextStyle::plain, {LinkKind::control, std::string(option->key), 0, {}}});
  }
  return own;
}

/// What the column shows from top to bottom.
std::vector<TextLine> column_of(const Session& session, LessonReading& state, const Lesson& lesson, int index,
                                OwnBlocks& own) {
  const LessonStep& step = lesson.steps[static_cast<std::size_t>(index)];
  const float width = ImGui::GetContentRegionAvail().x;
  std::vector<TextLine> lines;
  // An open question is not answered by the numbers of another pixel.
  const auto story = state.holds_back ? nullptr : session.story(session.document().picked);
  const auto add = [&](const TextBlock& written, std::string_view mark) {
    const TextBlock* block = &written;
    if (written.figure) {
      TextBlock& drawn = own.drawn.emplace_back(written);
      drawn.figure = figure_of_pixel(written.figure, story.get());
      block = &drawn;
    }
    lay_out(*block, mark, Face::body, width, lines);
    lay_out_needs(*block, session, width, lines);
  };
  if (index == 0) {
    lay_out(own.source, {}, Face::small, width, lines);
    for (const TextBlock& block : lesson.blocks) add(block, mark_of(block));
  }
  lay_out(own.title, {}, Face::heading, width, lines);
  for (const TextBlock& block : step.blocks) add(block, mark_of(block));
  if (state.ask) {
    TextLine asks;
    asks.gap = px(12);
    asks.height = std::min(state.ask_height, ImGui::GetContentRegionAvail().y);  // what is higher can be scrolled
    asks.begins_block = asks.asks = true;
    lines.push_back(std::move(asks));
  }
  if (state.verdict) lay_out_verdict(own, *state.verdict, width, lines);
  if (!state.holds_back)
    for (const TextBlock& hint : step.hints) add(hint, "→");
  for (const TextBlock& option : own.options) add(option, {});
  lay_out_claims(own, state.claims, width, lines);
  return lines;
}

/// How many characters a full line of the text holds, after the mean width of those that are there.
double line_length(const std::vector<TextLine>& lines) {
  double characters = 0, width = 0;
  for (const TextLine& line : lines)
    for (std::size_t i = 0; i < line.pieces.size(); ++i) {
      const TextPiece& piece = line.pieces[i];
      if (piece.control || piece.formula || piece.face == Face::heading || piece.face == Face::small) continue;
      for (const char c : piece.text) characters += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u ? 1 : 0;
      width += piece.width;
      if (i + 1 < line.pieces.size() && line.pieces[i + 1].x > piece.x + piece.width) {
        characters += 1;
        width += line.pieces[i + 1].x - piece.x - piece.width;
      }
    }
  return width > 0 ? ImGui::GetContentRegionAvail().x * characters / width : 0;
}

/// Shows the page with this line.
void turn_to_line(const std::vector<TextLine>& lines, std::vector<TextLine>::const_iterator line,
                  const std::vector<std::size_t>& starts, LessonReading& state) {
  if (line == lines.end()) return;
  const auto place = static_cast<std::size_t>(line - lines.begin());
  state.text.page = static_cast<int>(std::upper_bound(starts.begin(), starts.end(), place) - starts.begin()) - 1;
}

void turn_to_option(const std::vector<TextLine>& lines, const std::vector<std::size_t>& starts, LessonReading& state) {
  const std::string key = std::exchange(state.shown_option, {});
  if (key.empty()) return;
  const auto line = std::find_if(lines.begin(), lines.end(), [&](const TextLine& each) {
    return std::any_of(each.pieces.begin(), each.pieces.end(),
                       [&](const TextPiece& piece) { return piece.control && piece.span->link.target == key; });
  });
  turn_to_line(lines, line, starts, state);
}

void turn_to_verdict(const std::vector<TextLine>& lines, const std::vector<std::size_t>& starts, LessonReading& state) {
  if (!state.verdict || !std::exchange(state.questions.turn_to_verdict, false)) return;
  const auto line = std::find_if(lines.begin(), lines.end(), [](const TextLine& each) { return each.asks_again; });
  turn_to_line(lines, line, starts, state);
}

/// A script that looks for a control of the question turns to its page.
void turn_to_question(const std::vector<TextLine>& lines, const std::vector<std::size_t>& starts,
                      LessonReading& state) {
  const std::string& wanted = controls().revealing();
  if (!wanted.starts_with("question/") && !wanted.starts_with("predict/")) return;
  turn_to_line(lines, std::find_if(lines.begin(), lines.end(), [](const TextLine& each) { return each.asks; }), starts,
               state);
}

/// The wheel turns pages, unless it belongs to a control under the pointer.
void turn_by_wheel(ReadPage& read) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0 || !ImGui::IsWindowHovered() || wheel_is_taken()) return;
  read.page = std::clamp(read.page + (wheel < 0 ? 1 : -1), 0, std::max(read.pages - 1, 0));
}

/// Beside the line of a verdict, down from the end of the line before.
void draw_judged_bar(const TextLine& line, ImVec2 at, bool first) {
  const ImVec4& colour = *line.judged ? palette().right_mark : palette().wrong_mark;
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y - (first ? 0 : line.gap)}, {at.x + px(8), at.y + line.height},
                                            colour_u32(colour));
}

void ask_again_button(LessonReading& state) {
  state.ask_again |=
      button("ask-again", "Ask again", Emphasis::quiet,
             {.tooltip = "The question is open again, with this step's pixel and options.", .disabled = {}});
}

/// Where the question has its place on the page.
struct QuestionPlace {
  ImVec2 at;
  ImVec2 size;
};

constexpr double question_inset = 12, below_question = 8;  // beside its bar, and to what follows it

/// Answers where the question is to be drawn, if this page has it.
std::optional<QuestionPlace> draw_page(const PanelHost& host, LessonReading& state, const std::vector<TextLine>& lines,
                                       const std::vector<ClaimLayout>& measured) {
  Session& session = host.session;
  std::vector<PagePart> parts;
  parts.reserve(lines.size());
  for (const TextLine& line : lines) parts.push_back({line.gap, line.height, line.begins_block, line.stays_with_next});
  const auto starts = page_starts(parts, ImGui::GetContentRegionAvail().y);
  ReadPage& read = state.text;
  read.seen.now();
  read.line_length = line_length(lines);
  read.pages = static_cast<int>(starts.size());
  turn_to_option(lines, starts, state);
  turn_to_verdict(lines, starts, state);
  turn_to_question(lines, starts, state);
  read.page = std::clamp(read.page, 0, read.pages - 1);
  const auto page = static_cast<std::size_t>(read.page);
  const std::size_t end = page + 1 < starts.size() ? starts[page + 1] : lines.size();
  const bool claims_in_sight = std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(starts[page]),
                                           lines.begin() + static_cast<std::ptrdiff_t>(end),
                                           [](const TextLine& line) { return line.claim.has_value(); });
  if (claims_in_sight && state.claims.measure_changed(session)) redraw_after(0);  // these lines are of before
  std::optional<LinkTarget> followed;
  std::optional<QuestionPlace> question;
  ImVec2 at = ImGui::GetCursorScreenPos();
  for (std::size_t i = starts[page]; i < end; ++i) {
    if (i > starts[page]) at.y += lines[i].gap;
    ImGui::SetCursorScreenPos(at);
    if (lines[i].judged) draw_judged_bar(lines[i], at, i == starts[page] || !lines[i - 1].judged);
    if (lines[i].asks)
      question = QuestionPlace{at, {ImGui::GetContentRegionAvail().x, lines[i].height}};
    else if (lines[i].asks_again)
      ask_again_button(state);
    else if (lines[i].claim)
      claim_line(session, state.claims, *lines[i].claim, measured.at(*lines[i].claim));
    else if (auto clicked = draw_line(session, lines[i]))
      followed = std::move(clicked);
    at.y += lines[i].height;
  }
  if (followed) host.send(*followed);
  return question;
}

/// The height of a question that is new here, before it has its place: drawn where all of it is clipped.
void measure_question(LessonReading& state, const Lesson& lesson, int step) {
  const float width = ImGui::GetContentRegionAvail().x - px(question_inset);
  const std::string subject = fmt::format("{}/{}/{}", lesson.name, step, width);
  if (!state.ask || std::exchange(state.asked, subject) == subject) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginChild("measure", {width, 0});
  ImGui::PushClipRect(at, at, true);
  const float top = ImGui::GetCursorPosY();
  state.ask();
  state.ask_height = ImGui::GetCursorPosY() - top + px(below_question);
  ImGui::PopClipRect();
  ImGui::EndChild();
  ImGui::SetCursorScreenPos(at);
}

/// The question in its place, behind a bar of its own, so that it is not taken for text.
void draw_question(LessonReading& state, const QuestionPlace& place) {
  constexpr double bar = 3, inset = question_inset, below = below_question;
  ImGui::SetCursorScreenPos({place.at.x + px(inset), place.at.y});
  ImGui::BeginChild("question", {place.size.x - px(inset), place.size.y});
  const float top = ImGui::GetCursorPosY();
  state.ask();
  const float height = ImGui::GetCursorPosY() - top + px(below);
  ImGui::EndChild();
  ImGui::GetWindowDrawList()->AddRectFilled(place.at, {place.at.x + px(bar), place.at.y + place.size.y - px(below)},
                                            colour_u32(palette().line_strong));
  if (std::abs(height - state.ask_height) > 1) redraw_after(0);
  state.ask_height = height;
}

/// "step 2 of 7, page 1 of 2", and the same in fewer signs, the shortest last.
std::vector<std::string> place_texts(int index, int count, const ReadPage& read) {
  const std::string step = fmt::format("step {} of {}", index + 1, count),
                    brief = fmt::format("{}/{}", index + 1, count);
  if (read.pages <= 1) return {step, brief};
  return {fmt::format("{}, page {} of {}", step, read.page + 1, read.pages),
          fmt::format("{}, {}/{}", brief, read.page + 1, read.pages), brief};
}

/// The first of the texts that fits; none where not even the last one does.
std::string_view first_that_fits(const std::vector<std::string>& texts, float room) {
  for (const std::string& text : texts)
    if (text_width(text) <= room) return text;
  return {};
}

/// Back, Next and the rest, and where one is.
void buttons(Session& session, LessonReading& state, const Lesson& lesson, int index) {
  const ReadPage& read = state.text;
  const int count = static_cast<int>(lesson.steps.size());
  const float space = ImGui::GetStyle().ItemSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const std::vector<std::string> places = place_texts(index, count, read);
  const float words = button_width("Back") + button_width("Next") + button_width("Again") + button_width("×");
  const bool narrow = words + 3 * space + px(6) + text_width(places[1], Face::small) > room;
  const bool first = index == 0 && read.page == 0, last = index + 1 == count && read.page + 1 >= read.pages;
  int by = 0;
  if (button("before", narrow ? "‹" : "Back", Emphasis::plain,
             {.tooltip = "The page before, then the step before (Page Up; Shift Page Up: always the step).",
              .disabled = first ? "This is the beginning of the lesson." : ""}))
    by = -1;
  ImGui::SameLine();
  const std::string_view on =
      last ? "The next lesson." : "The next page, then the next step (Page Down; Enter: always the step).";
  if (button("next", narrow ? "›" : "Next", Emphasis::primary, {.tooltip = on})) by = 1;
  ImGui::SameLine();
  if (button("again", narrow ? "↺" : "Again", Emphasis::plain, {.tooltip = "Puts this step's settings back."})) {
    go_to_step(session, lesson.name, index);
    state.column.step = -1;  // begins with its text
  }
  ImGui::SameLine();
  const bool close = button("close", "×", Emphasis::quiet, {.tooltip = "Closes the lesson."});
  ImGui::SameLine(0, px(6));
  const float body = ImGui::GetFontSize();
  const FontScope font(Face::small);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float drop = (body - ImGui::GetFontSize()) / 2;  // text keeps the base line of the buttons before it
  ImGui::SetCursorScreenPos({at.x, std::floor(at.y + drop)});
  const std::string_view place = first_that_fits(places, ImGui::GetContentRegionAvail().x);
  show_text(place, {.quiet = true});
  if (!place.empty()) controls().record("place", places.front());
  tooltip(places.front());
  if (!state.questions.place.settled()) by = 0;
  if (last && by > 0)
    move_lesson(session, 1);
  else if (by != 0)
    read_lesson(session, state, by);
  if (close) close_lesson(session);
}

}  // namespace

LessonReading::LessonReading(const PanelHost& host)
    : shelf(host.session, host.wake), claims(host.wake),
      questions(host.wake, host.remember, shelf), read{parse_read_lessons(host.remembered(read_lessons_key)),
                                                       [&host](std::string lines) {
                                                         host.remember_lines(read_lessons_key, std::move(lines));
                                                       }} {}

LessonPanel::LessonPanel(const PanelHost& host)
    : Panel(host, {.name = region_names::lesson,
                   .place = PanelPlace::left,
                   .heading = "Lesson",
                   .brief = "Lesson",
                   .command = "Lesson",
                   .help = "The text of a lesson's step."}),
      state(host) {}

bool LessonPanel::draw(const Context&) {
  const Lesson* lesson = state.shelf.open();
  if (!lesson || lesson->steps.empty()) return false;
  const int index = std::clamp(session_.document().step, 0, static_cast<int>(lesson->steps.size()) - 1);
  follow_step(session_, state.text);
  if (!state.holds_back) state.claims.follow(session_, *lesson, state.shelf.version());
  OwnBlocks own = own_blocks(session_, state, *lesson, lesson->steps[static_cast<std::size_t>(index)]);
  ImGui::BeginChild("text", {0, -(ImGui::GetFrameHeightWithSpacing() + px(2))}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  turn_by_wheel(state.text);
  measure_question(state, *lesson, index);  // its controls have names of their own
  std::optional<QuestionPlace> question;
  {
    const NameScope scope("lesson");
    const std::vector<TextLine> lines = column_of(session_, state, *lesson, index, own);
    question = draw_page(host_, state, lines, own.measured);
  }
  if (question && state.ask) draw_question(state, *question);
  ImGui::EndChild();
  note_read(state, *lesson, index, state.text);
  const NameScope scope("lesson");
  buttons(session_, state, *lesson, index);
  return false;
}

void LessonPanel::offer(Values& out) {
  out.offer("lesson/pages", [this] { return state.text.pages; });
  out.offer("lesson/page", [this] { return state.text.page + 1; });
  out.offer("lesson/column", [this] {
    const LessonColumn& column = state.column;
    return !column.shared ? "both" : column.shows == ColumnShows::text ? "text" : "tool";
  });
  out.offer("lesson/line-length", [this] { return state.text.line_length; });
  out.offer_below("flash/", [](std::string_view name) { return script_text(flashes(name)); });
  out.offer("question/open", [this] { return state.questions.open(); });
  out.offer("question/given", [this] { return state.questions.given(); });
  out.offer("question/verdict", [this] {
    const auto verdict = shown_verdict(state.questions);
    return verdict ? verdict->sentence : "";
  });
  out.offer("question/points", [this] {
    const Judgement* verdict = state.questions.verdict();
    return verdict ? verdict->points : 0;
  });
}

void LessonPanel::update() {
  state.shelf.update();
  state.claims.hold(host_.needs_processors());
  if (std::exchange(state.ask_again, false)) {
    go_to_step(session_, session_.document().lesson, session_.document().step);
    state.questions.ask_again();
  }
  state.questions.tell_skipped(session_);
  const Document& document = session_.document();
  state.questions.place.shows(fmt::format("{}/{}/{}/{}", document.lesson, document.step, state.text.page,
                                          state.column.shows == ColumnShows::text ? "text" : "tool"));
  state.verdict = shown_verdict(state.questions);
  state.holds_back = state.questions.holds_back();
  state.questions.hold(host_.needs_processors());
}

void LessonPanel::take(const PanelMessage& message) {
  const auto* target = std::get_if<LinkTarget>(&message);
  if (!target) return;
  const TextLink& link = target->link;
  if (link.kind == LinkKind::step) go_to_step(session_, session_.document().lesson, link.step);
  if (link.kind == LinkKind::lesson) go_to_step(session_, link.target, link.step);
  // In a lesson the step's text has the control, else the options panel.
  const bool option = link.kind == LinkKind::option || link.kind == LinkKind::control;
  if (!option || session_.document().mode != ScreenMode::lesson) return;
  state.shown_option = link.target;
  flash({"lesson/a/" + link.target, "lesson/b/" + link.target});
}

}  // namespace ps::gui
