#include <fmt/format.h>

#include "base/foreign_text.h"
#include "engine/block.h"
#include "engine/figure.h"
#include "engine/lesson.h"
#include "engine/markdown.h"
#include "engine/place_in_text.h"
#include "engine/words.h"
#include "options/option.h"

namespace ps {
namespace {

/// Reads a lesson line by line: "## " begins a step, "```" a block. All other lines are text; where they are not, the
/// text has empty lines, so that its lines are those of the file.
class LessonParser {
 public:
  LessonParser(const std::string& name, const std::string& file) : file_(file) { lesson_.name = name; }

  void read_line(std::string_view line) {
    ++line_;
    const std::string_view text = without_blanks(line);
    if (is_text(text)) {
      if (lesson_.steps.empty() && text.starts_with(">"))
        throw InputError(place(), "a hint before the first step", "hints inside steps");
      text_ += line;
    } else if ((block_ == "notes" || block_ == "goals" || block_ == "figure") && text != "```") {
      prose_ += line;
      prose_ += '\n';
    } else {
      read_structure(text);
    }
    text_ += '\n';
  }

  Lesson finish() {
    end_text();
    if (!block_.empty()) throw InputError(block_place_, "a block that does not end", "a line ```");
    const SourcePlace whole{file_, 0, 0};
    if (lesson_.title.empty()) throw InputError(whole, "no title", "a line '# Title'");
    if (lesson_.source.empty()) throw InputError(whole, "no source", "a line 'source: where it comes from'");
    if (lesson_.steps.empty()) throw InputError(whole, "no steps", "lines '## Title of the step'");
    for (const LessonStep& step : lesson_.steps)
      if (step.state.scene.empty())
        throw InputError(whole, fmt::format("no scene for the step '{}'", step.title), "a line 'scene NAME'");
    for (const StepLink& link : step_links_)
      if (link.step >= static_cast<int>(lesson_.steps.size()))
        throw InputError(link.place, fmt::format("a link to step {}", link.step + 1),
                         fmt::format("steps 1 to {}", lesson_.steps.size()));
    return std::move(lesson_);
  }

 private:
  SourcePlace place() const { return {file_, line_, 1}; }

  bool is_text(std::string_view text) const {
    return block_.empty() && !text.starts_with("```") && !text.starts_with("# ") && !text.starts_with("## ") &&
           !text.starts_with("source:") && !is_renderer_line(text);
  }

  /// In a step it is text like any other.
  bool is_renderer_line(std::string_view text) const { return lesson_.steps.empty() && text.starts_with("renderer:"); }

  void read_structure(std::string_view text) {
    if (!block_.empty()) return read_block_line(text);
    if (text.starts_with("```")) {
      block_ = without_blanks(text.substr(3));
      block_place_ = place();
      if (block_ != "settings" && block_ != "claim" && block_ != "question" && block_ != "notes" && block_ != "goals" &&
          block_ != "task" && block_ != "figure")
        throw InputError(place(), fmt::format("a block named '{}'", block_),
                         "```settings, ```goals, ```figure, ```claim, ```question, ```task or ```notes");
    } else if (text.starts_with("## ")) {
      begin_step(std::string(without_blanks(text.substr(3))));
    } else if (text.starts_with("# ")) {
      if (!lesson_.title.empty()) throw InputError(place(), "a second title", "## before the title of a step");
      lesson_.title = without_blanks(text.substr(2));
    } else if (text.starts_with("source:")) {
      lesson_.source = without_blanks(text.substr(7));
    } else if (is_renderer_line(text)) {
      lesson_.renderer = without_blanks(text.substr(9));
      Settings trial;
      at_place(place(), [&] { parse_assignment("renderer=" + lesson_.renderer, trial); });
    }
  }

  /// The text that was collected belongs to the step before, or to the lesson as a whole.
  void end_text() {
    StepText text = read_markdown(text_, file_, text_line_);
    std::vector<TextBlock>& blocks = open_blocks();
    blocks.insert(blocks.end(), text.blocks.begin(), text.blocks.end());
    if (!lesson_.steps.empty()) {
      std::vector<TextBlock>& hints = lesson_.steps.back().hints;
      hints.insert(hints.end(), text.hints.begin(), text.hints.end());
    }
    step_links_.insert(step_links_.end(), text.step_links.begin(), text.step_links.end());
    text_.clear();
    text_line_ = line_;
  }

  std::vector<TextBlock>& open_blocks() { return lesson_.steps.empty() ? lesson_.blocks : lesson_.steps.back().blocks; }

  void begin_step(std::string title) {
    end_text();
    LessonStep step;
    step.title = std::move(title);
    step.state = common_;
    lesson_.steps.push_back(std::move(step));
  }

  void read_block_line(std::string_view text) {
    if (text == "```") return end_block();
    if (text.empty()) return;
    const std::string word(take_word(text));
    lines_.push_back({word, std::string(without_blanks(text)), place()});
  }

  void end_block() {
    const bool in_step = !lesson_.steps.empty();
    if (block_ == "question") {
      if (!in_step) throw InputError(block_place_, "a question before the first step", "questions inside steps");
      if (lesson_.steps.back().question) throw InputError(block_place_, "a second question", "one for each step");
      lesson_.steps.back().question = read_question(lines_, lesson_.steps.back().state, block_place_);
    } else if (block_ == "claim") {
      if (!in_step) throw InputError(block_place_, "a claim before the first step", "claims inside steps");
      lesson_.steps.back().claims.push_back(read_claim(lines_, lesson_.steps.back().state, block_place_));
    } else if (block_ == "task") {
      if (!in_step) throw InputError(block_place_, "a task before the first step", "tasks inside steps");
      if (!lesson_.steps.back().write.empty()) throw InputError(block_place_, "a second task", "one for each step");
      lesson_.steps.back().write = read_task(lines_, lesson_.name, block_place_);
    } else if (block_ == "notes") {
      end_notes();
    } else if (block_ == "goals") {
      end_goals();
    } else if (block_ == "figure") {
      end_figure();
    } else {
      LessonState& state = in_step ? lesson_.steps.back().state : common_;
      for (const BlockLine& line : lines_)
        at_place(line.place, [&] {
          if (!read_state_line(line, state))
            throw InputError(line.place, fmt::format("'{} {}'", line.word, line.rest),
                             "scene, set, set-b, set-both, edit, show, mode, stage, sweep, experiment, or a part of a "
                             "permalink such as size, pixel, camera, zoom, region, gain, event, vertex");
        });
    }
    block_.clear();
    lines_.clear();
  }

  /// A figure stands between the text before and behind it.
  void end_figure() {
    end_text();
    auto figure = std::make_shared<const Figure>(read_figure(prose_, file_, block_place_.line + 1));
    prose_.clear();
    TextBlock block{.kind = BlockKind::figure, .spans = {{figure->description}}};
    block.figure = std::move(figure);
    open_blocks().push_back(std::move(block));
  }

  void end_goals() {
    if (!lesson_.steps.empty()) throw InputError(block_place_, "goals in a step", "goals before the first step");
    if (!lesson_.goals.empty()) throw InputError(block_place_, "a second block of goals", "one");
    std::string_view prose = prose_;
    for (int line = block_place_.line + 1; !prose.empty(); ++line)
      for (TextBlock& goal : read_markdown(take_line(prose), file_, line).blocks)
        lesson_.goals.push_back(std::move(goal));
    prose_.clear();
    if (lesson_.goals.empty()) throw InputError(block_place_, "goals without words", "a line for each");
  }

  void end_notes() {
    StepText text = read_markdown(prose_, file_, block_place_.line + 1);
    prose_.clear();
    if (text.blocks.empty() || !text.hints.empty())
      throw InputError(block_place_, text.blocks.empty() ? "notes without words" : "a hint in notes", "paragraphs");
    std::vector<TextBlock>& notes = lesson_.steps.empty() ? lesson_.notes : lesson_.steps.back().notes;
    if (!notes.empty()) throw InputError(block_place_, "a second block of notes", "one, and one for each step");
    notes = std::move(text.blocks);
    step_links_.insert(step_links_.end(), text.step_links.begin(), text.step_links.end());
  }

  std::string file_;
  Lesson lesson_;
  LessonState common_;  // of the block before the first step: where each step starts
  int line_ = 0;
  std::vector<StepLink> step_links_;
  std::string text_;   // of the step, as it is in the file
  int text_line_ = 1;  // where that begins
  std::string block_;  // name of the open block; empty outside
  SourcePlace block_place_;
  std::string prose_;  // of the open block of notes or goals, as it is in the file
  std::vector<BlockLine> lines_;
};

}  // namespace

Lesson parse_lesson(std::string_view text, const std::string& name, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // Windows' Notepad writes it
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (const std::size_t at = bytes_of_utf8(text); at < text.size())
    throw InputError(place_in(text, at, {file, 1, 1}),
                     fmt::format("the byte {:#04x}, which is not UTF-8", static_cast<unsigned char>(text[at])),
                     "a file saved in that encoding");
  LessonParser parser(name, file);
  while (!text.empty()) parser.read_line(take_line(text));
  return parser.finish();
}

}  // namespace ps
