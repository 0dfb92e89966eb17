#include "gui/panels/lesson/text_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/maths_layout.h"
#include "gui/panels/lesson/option_field.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/maths_draw.h"
#include "gui/widgets/screen_painter.h"

namespace ps::gui {
namespace {

constexpr float line_spacing = 1.2f;  // of the font's own line
constexpr double block_gap = 7, item_gap = 3;

/// Pieces between which no line may end: a name in bold and the full stop behind it.
struct Word {
  std::vector<TextPiece> pieces;  ///< x from the word's left end
  float width = 0;

  void add(TextPiece piece) {
    piece.x = width;
    width += piece.width;
    pieces.push_back(piece);
  }
};

Face face_of(TextStyle style, Face plain) {
  if (plain != Face::body) return plain;
  switch (style) {
  case TextStyle::plain:
    return plain;
  case TextStyle::emphasis:
    return Face::italic;
  case TextStyle::strong:
    return Face::bold;
  case TextStyle::code:
    return Face::mono;
  }
  return plain;
}

float width_in(Face face, std::string_view text) {
  const FontScope font(face);
  return text_width(text);
}

/// The controls of an option, side by side, as one word each.
void add_controls(const TextSpan& span, float line_width, std::vector<Word>& words) {
  const Option* option = find_option(span.link.target);
  for (const Side side : control_sides(span.link)) {
    TextPiece piece;
    piece.width = std::floor(std::min(option_field_width(*option), line_width));
    piece.span = &span;
    piece.control = side;
    words.emplace_back().add(piece);
  }
}

/// A part of a formula; `part` counts them.
TextPiece formula_piece(const TextSpan& span, std::size_t part, Face face, MathsBox box) {
  TextPiece piece;
  piece.text = std::string_view(span.text).substr(std::min(part, span.text.size()));  // another address for each
  piece.width = std::ceil(box.width);
  piece.face = face;
  piece.span = &span;
  piece.formula = std::make_shared<const MathsBox>(std::move(box));
  return piece;
}

/// A formula in the text; `open`: its first part belongs to the last word.
void add_formula(const TextSpan& span, Face face, float line_width, bool open, std::vector<Word>& words) {
  const WindowMathsFont font(maths_faces(face));
  std::size_t part = 0;
  for (MathsBox& box : set_in_text(*span.formula, font, line_width)) {
    if (!open || part > 0) words.emplace_back();
    words.back().add(formula_piece(span, part++, face, std::move(box)));
  }
}

/// The lines of a formula that is a paragraph of its own, as one word each.
std::vector<Word> lines_of_formula(const TextSpan& span, Face face, float line_width) {
  const WindowMathsFont font(maths_faces(face));
  std::vector<Word> words;
  for (MathsBox& box : set_displayed(*span.formula, font, line_width))
    words.emplace_back().add(formula_piece(span, words.size(), face, std::move(box)));
  return words;
}

std::vector<Word> words_of(const TextBlock& block, Face plain, float line_width) {
  if (display_formula(block)) return lines_of_formula(block.spans.front(), plain, line_width);
  std::vector<Word> words;
  bool open = false;  // what comes next belongs to the last word
  for (const TextSpan& span : block.spans) {
    if (span.link.kind == LinkKind::control) {
      add_controls(span, line_width, words);
      open = true;
      continue;
    }
    if (span.formula) {
      add_formula(span, plain, line_width, open && !words.empty(), words);
      open = true;
      continue;
    }
    const Face face = face_of(span.style, plain);
    const std::string_view text = span.text;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      if (end > at) {
        if (!open) words.emplace_back();
        const std::string_view part = text.substr(at, end - at);
        words.back().add({0, width_in(face, part), part, face, &span, {}});
      }
      open = end == text.size() && (end > at || (open && at == 0));
      at = end + 1;
    }
  }
  return words;
}

/// The room that the formulas of a line need above and below words in this face, which have `text_height`.
void make_room(TextLine& line, Face face, float text_height) {
  const FontScope font(face);
  const float baseline = std::floor((text_height - ImGui::GetFontSize()) / 2) + ascent_of(face);
  const float free = px(2);
  for (const TextPiece& piece : line.pieces) {
    if (!piece.formula) continue;
    line.rise = std::max(line.rise, std::ceil(piece.formula->above + free - baseline));
    line.fall = std::max(line.fall, std::ceil(piece.formula->below + free - (text_height - baseline)));
  }
}

float line_height(const TextLine& line, float text_height) {
  const bool control = std::any_of(line.pieces.begin(), line.pieces.end(),
                                   [](const TextPiece& piece) { return piece.control.has_value(); });
  const float words = control ? std::max(text_height, ImGui::GetFrameHeight() + px(4)) : text_height;
  return line.rise + words + line.fall;
}

/// Where a word starts that begins a new line: B's control below A's, everything else at `indent`.
float start_below(const TextLine& above, const Word& word, float indent) {
  if (above.pieces.empty() || word.pieces.empty()) return indent;
  const TextPiece &last = above.pieces.back(), &first = word.pieces.front();
  return last.control && first.control && last.span == first.span ? last.x : indent;
}

float gap_before(BlockKind kind, bool first_of_list) {
  const bool item = kind == BlockKind::bullet || kind == BlockKind::numbered;
  return px(item && !first_of_list ? item_gap : block_gap);
}

}  // namespace

std::string mark_of(const TextBlock& block) {
  switch (block.kind) {
  case BlockKind::paragraph:
  case BlockKind::heading:
  case BlockKind::figure:
    return {};
  case BlockKind::bullet:
    return "•";
  case BlockKind::numbered:
    return fmt::format("{}.", block.number);
  }
  return {};
}

std::vector<Side> control_sides(const TextLink& link) {
  return link.side ? std::vector{*link.side} : std::vector(both_sides.begin(), both_sides.end());
}

float text_line_height(Face face) {
  const FontScope font(face);
  return std::floor(ImGui::GetFontSize() * line_spacing);
}

void lay_out(const TextBlock& block, std::string_view mark, Face face, float width, std::vector<TextLine>& lines) {
  if (block.kind == BlockKind::heading && face == Face::body) face = Face::bold;
  const float height = text_line_height(face), space = width_in(face, " ");
  const bool displayed = display_formula(block) != nullptr;
  const float indent = displayed ? px(22) : mark.empty() ? 0 : std::max(px(22), width_in(face, mark) + px(8));
  const bool follows_item = !lines.empty() && !lines.back().mark.empty();
  TextLine line;
  line.begins_block = true;
  line.mark = mark;
  line.gap = lines.empty() ? 0 : gap_before(block.kind, !follows_item);
  line.figure = block.figure.get();
  if (line.figure && face != Face::caption) {
    const ScreenPainter painter(*ImGui::GetWindowDrawList());
    line.height = static_cast<float>(figure_height(painter, *line.figure, width));
    return lines.push_back(std::move(line));
  }
  float x = indent;
  const auto end_line = [&] {
    make_room(line, face, height);
    line.height = line_height(line, height);
    line.stays_with_next = block.kind == BlockKind::heading || face == Face::heading;
    lines.push_back(std::move(line));
    line = {};
    line.figure = block.figure.get();
    x = indent;
  };
  for (const Word& word : words_of(block, face, width - indent)) {
    if (x > indent && (displayed || x + space + word.width > width)) {
      const float start = start_below(line, word, indent);
      end_line();
      x = start;
    } else if (x > indent) {
      x += space;
    }
    for (TextPiece piece : word.pieces) {
      piece.x += x;
      line.pieces.push_back(piece);
    }
    x += word.width;
  }
  if (!line.pieces.empty()) end_line();
}

}  // namespace ps::gui
