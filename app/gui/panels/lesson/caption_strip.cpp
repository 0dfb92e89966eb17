#include "gui/panels/lesson/caption_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gui/panels/lesson/text_pages.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/screen_painter.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr float lines_of_page = 3;

/// The step's text without links and controls, which are not for an audience. While a question is open, without what
/// to look for, which would answer it.
std::vector<TextBlock> spoken_blocks(const LessonStep& step, bool holds_back) {
  std::vector<TextBlock> blocks = step.blocks;
  if (!holds_back) blocks.insert(blocks.end(), step.hints.begin(), step.hints.end());
  for (TextBlock& block : blocks)
    for (TextSpan& span : block.spans) {
      span.style = TextStyle::plain;
      span.link = {};
    }
  return blocks;
}

/// The pages of a caption are full: a page may end within a paragraph, and no space parts these.
std::vector<std::size_t> caption_pages(const std::vector<TextLine>& lines, float height) {
  std::vector<PagePart> parts;
  parts.reserve(lines.size());
  for (const TextLine& line : lines) parts.push_back({0, line.height, false, false});
  return page_starts(parts, height);
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

/// A figure, large and on a plate of its own above the strip, whose upper edge is at `low`.
void draw_projected_figure(const Figure& figure, float low) {
  constexpr float share_of_width = 0.55f, share_of_room = 0.92f;
  const ImVec2 window = ImGui::GetMainViewport()->Size;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  ScreenPainter painter(list);
  const float edge = px(16);
  float width = share_of_width * window.x;
  const auto height_at = [&] { return static_cast<float>(figure_height(painter, figure, width)); };
  while (width > px(200) && height_at() + 2 * edge > share_of_room * low) width *= 0.95f;
  const float height = height_at(), x = (window.x - width) / 2, y = low - height - 2 * edge;
  list.AddRectFilled({x - edge, y - edge}, {x + width + edge, y + height + edge}, colour_u32(palette().panel), px(6));
  list.AddRect({x - edge, y - edge}, {x + width + edge, y + height + edge}, colour_u32(palette().line_strong), px(6));
  draw_figure(painter, figure, {x, y}, width);
}

}  // namespace

float caption_height() { return lines_of_page * text_line_height(Face::caption) + px(40); }

void caption_strip(Session& session, LessonReading& state) {
  const NameScope scope("caption");
  const Lesson* lesson = state.shelf.open();
  if (!lesson || lesson->steps.empty()) return;
  const int count = static_cast<int>(lesson->steps.size());
  const int index = std::clamp(session.document().step, 0, count - 1);
  const LessonStep& step = lesson->steps[static_cast<std::size_t>(index)];
  ReadPage& caption = state.caption;
  follow_step(session, caption);
  const FontScope font(Face::caption);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const std::vector<TextBlock> blocks = spoken_blocks(step, state.holds_back);
  std::vector<TextLine> lines;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    lay_out(blocks[i], i < step.blocks.size() ? mark_of(blocks[i]) : "→", Face::caption, room.x, lines);
  const std::vector<std::size_t> starts = caption_pages(lines, lines_of_page * text_line_height(Face::caption));
  caption.seen.now();
  caption.pages = static_cast<int>(starts.size());
  caption.page = std::clamp(caption.page, 0, caption.pages - 1);
  {
    const FontScope small(Face::bold);
    value_text("place", fmt::format("{}   {} of {}, page {} of {}", step.title, index + 1, count, caption.page + 1,
                                    caption.pages));
  }
  note_read(state, *lesson, index, caption);
  const auto page = static_cast<std::size_t>(caption.page);
  const std::size_t end = page + 1 < starts.size() ? starts[page + 1] : lines.size();
  ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 from = at;
  std::string shown;
  const Figure* figure = nullptr;
  for (std::size_t i = starts[page]; i < end; ++i) {
    ImGui::SetCursorScreenPos(at);
    draw_line(session, lines[i]);
    if (lines[i].figure) figure = lines[i].figure;
    at.y += lines[i].height;
    shown += (shown.empty() ? "" : "\n") + words_of_line(lines[i]);
  }
  if (figure) draw_projected_figure(*figure, ImGui::GetWindowPos().y);
  controls().record("text", from, {from.x + room.x, at.y}, shown);
}

}  // namespace ps::gui
