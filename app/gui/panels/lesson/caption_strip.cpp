#include "gui/panels/lesson/caption_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr std::size_t lines_of_page = 3;

/// A paragraph without the marks of bold, emphasis and code.
std::string without_marks(std::string text) {
  std::erase_if(text, [](char c) { return c == '*' || c == '`'; });
  return text;
}

std::vector<std::string> lines_of(const LessonStep& step, float width) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& paragraph) {
    const std::string wrapped = in_lines(without_marks(paragraph), width);
    for (std::size_t from = 0; from <= wrapped.size();) {
      const std::size_t to = std::min(wrapped.find('\n', from), wrapped.size());
      lines.push_back(wrapped.substr(from, to - from));
      from = to + 1;
    }
  };
  for (const std::string& paragraph : step.paragraphs) add(paragraph);
  for (const std::string& hint : step.hints) add("→ " + hint);
  return lines;
}

/// A new step begins on its first page, or on its last one where the previous page was asked for.
void follow_step(const Session& session, CaptionState& caption) {
  const Document& document = session.document();
  if (caption.lesson == document.lesson && caption.step == document.step) return;
  const bool went_back = caption.lesson == document.lesson && document.step == caption.step - 1;
  caption.page = went_back && caption.turned_back ? std::numeric_limits<int>::max() : 0;
  caption.turned_back = false;
  caption.lesson = document.lesson;
  caption.step = document.step;
}

}  // namespace

float caption_height() {
  const FontScope font(Face::caption);
  return static_cast<float>(lines_of_page) * ImGui::GetTextLineHeightWithSpacing() + px(40);
}

void caption_strip(Session& session, LessonShelf& shelf) {
  const NameScope scope("caption");
  const Lesson* lesson = shelf.open(session);
  if (!lesson || lesson->steps.empty()) return;
  const int count = static_cast<int>(lesson->steps.size());
  const int index = std::clamp(session.document().step, 0, count - 1);
  const LessonStep& step = lesson->steps[static_cast<std::size_t>(index)];
  CaptionState& caption = shelf.caption;
  follow_step(session, caption);
  const FontScope font(Face::caption);
  const std::vector<std::string> lines = lines_of(step, ImGui::GetContentRegionAvail().x);
  caption.pages = std::max(1, static_cast<int>((lines.size() + lines_of_page - 1) / lines_of_page));
  caption.page = std::clamp(caption.page, 0, caption.pages - 1);
  {
    const FontScope small(Face::bold);
    value_text("place", fmt::format("{}   {} of {}, page {} of {}", step.title, index + 1, count, caption.page + 1,
                                    caption.pages));
  }
  const std::size_t first = static_cast<std::size_t>(caption.page) * lines_of_page;
  std::string shown;
  for (std::size_t i = first; i < std::min(lines.size(), first + lines_of_page); ++i)
    shown += (shown.empty() ? "" : "\n") + lines[i];
  value_text("text", shown);
}

void turn_caption(Session& session, LessonShelf& shelf, int by) {
  CaptionState& caption = shelf.caption;
  const int page = caption.page + by;
  if (page >= 0 && page < caption.pages) {
    caption.page = page;
    return;
  }
  caption.turned_back = by < 0;
  move_step(session, shelf, by);
}

}  // namespace ps::gui
