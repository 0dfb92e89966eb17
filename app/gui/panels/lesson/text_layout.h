#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/figure.h"
#include "engine/maths_box.h"
#include "engine/text.h"
#include "gui/theme/theme.h"
#include "options/waking.h"

namespace ps::gui {

/// What is at one place of a line: a word or a part of one in one face, a formula or a part of one, or a live
/// control of one side.
struct TextPiece {
  float x = 0, width = 0;  ///< from the left end of the line, window pixels
  std::string_view text;
  Face face = Face::body;
  const TextSpan* span = nullptr;                ///< from which it is
  std::optional<Side> control;                   ///< whose option is changed here
  std::shared_ptr<const MathsBox> formula = {};  ///< in place of the text
};

/// What a live control of the text above needs to act.
struct ControlNeed {
  const Option* option = nullptr;
  std::vector<Side> sides;
  Waking waking;
  std::string prefix;  ///< "Shading: ", or "A Shading: " where only A's control needs it, beside B's
};

struct TextLine {
  float gap = 0, height = 0;  ///< free space above it, and its own height
  float rise = 0, fall = 0;   ///< of the height: what formulas need above and below a line of words
  std::vector<TextPiece> pieces;
  std::string mark;  ///< in front of the first line of an item: "•", "1."
  bool begins_block = false;
  bool stays_with_next = false;      ///< of a heading, and of what needs are said of
  std::optional<ControlNeed> need;   ///< in place of pieces
  const Figure* figure = nullptr;    ///< in place of pieces; beside a caption, which has its words
  std::optional<std::size_t> claim;  ///< in place of pieces: what is measured for this claim of the step
  std::optional<bool> judged;        ///< of an answer: a bar beside it shows whether it was right
  bool asks = false;                 ///< in place of pieces: the step's question, with the controls for its answer
  bool asks_again = false;           ///< in place of pieces: the button that opens the step's question again
};

/// Adds the lines of a block in lines of at most this width, which end between words. `mark` is written before the
/// first; the others are indented as it is. The block must outlive the lines.
void lay_out(const TextBlock& block, std::string_view mark, Face face, float width, std::vector<TextLine>& lines);

/// The height of a line of words in this face.
float text_line_height(Face face);

/// The mark of a block in the text: a bullet, a number, or nothing.
std::string mark_of(const TextBlock& block);

/// The sides for which a control is shown where the text has one.
std::vector<Side> control_sides(const TextLink& link);

}  // namespace ps::gui
