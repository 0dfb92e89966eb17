#include "gui/panels/lesson/caption_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gui/panels/lesson/text_layout.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr std::size_t lines_of_page = 3;

std::vector<std::string> lines_of(const LessonStep& step, float width) {
  std::vector<std::string> lines;
  const auto add = [&](const std::string& paragraph) {
    const std::string wrapped = in_lines(paragraph, width);
    for (std::size_t from = 0; from <= wrapped.size();) {
      const std::size_t to = std::min(wrapped.find('\n', from), wrapped.size());
      lines.push_back(wrapped.substr(from, to - from));
      from = to + 1;
    }
  };
  for (const TextBlock& block : step.blocks) {
    const std::string mark = mark_of(block);
    add(mark.empty() ? plain_text(block) : mark + " " + plain_text(block));
  }
  for (const TextBlock& hint : step.hints) add("→ " + plain_text(hint));
  return lines;
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
  ReadPage& caption = shelf.caption;
  follow_step(session, caption);
  const FontScope font(Face::caption);
  const std::vector<std::string> lines = lines_of(step, ImGui::GetContentRegionAvail().x);
  caption.frame = ImGui::GetFrameCount();
  caption.pages = std::max(1, static_cast<int>((lines.size() + lines_of_page - 1) / lines_of_page));
  caption.page = std::clamp(caption.page, 0, caption.pages - 1);
  {
    const FontScope small(Face::bold);
    value_text("place", fmt::format("{}   {} of {}, page {} of {}", step.title, index + 1, count, caption.page + 1,
                                    caption.pages));
  }
  note_read(shelf, *lesson, index, caption);
  const std::size_t first = static_cast<std::size_t>(caption.page) * lines_of_page;
  std::string shown;
  for (std::size_t i = first; i < std::min(lines.size(), first + lines_of_page); ++i)
    shown += (shown.empty() ? "" : "\n") + lines[i];
  value_text("text", shown);
}

}  // namespace ps::gui
