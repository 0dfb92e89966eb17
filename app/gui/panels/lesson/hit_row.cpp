#include "gui/panels/lesson/hit_row.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/draw.h"
#include "gui/widgets/picture_tiles.h"
#include "gui/widgets/shorten.h"

namespace ps::gui {
namespace {

constexpr double picture_side = 76, row_inset = 8;  // of the picture, and around what is in a row; at scale 1

float line_of(Face face) { return theme().font(face)->FontSize + px(3); }

/// Title and step, and two lines of text.
float row_height() { return std::max(px(picture_side), 4 * line_of(Face::body)) + px(row_inset); }

/// The lines with a ground behind the marked words, which are not broken.
void draw_marked(ImDrawList& list, ImVec2 at, const std::string& lines, const std::vector<TextRange>& marked) {
  const float height = ImGui::GetTextLineHeight();
  for (const TextRange& range : marked) {
    const std::string_view before = std::string_view(lines).substr(0, range.begin);
    const std::size_t line = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const auto above = static_cast<float>(std::count(before.begin(), before.end(), '\n'));
    const float x = at.x + text_width(before.substr(line)), y = at.y + above * height;
    const float width = text_width(std::string_view(lines).substr(range.begin, range.end - range.begin));
    list.AddRectFilled({x - px(2), y}, {x + width + px(2), y + height}, colour_u32(palette().field_active), px(3));
    list.AddLine({x, y + height}, {x + width, y + height}, colour_u32(palette().text), px(1.5));
  }
  draw_lines(at, lines, palette().text);
}

std::string step_text(const HitRow& row) {
  if (row.hit.place == HitPlace::title) return short_length(row.lesson.length) + ". " + row.lesson.source;
  return fmt::format("Step {}: {}", row.hit.step + 1, row.lesson.steps[static_cast<std::size_t>(row.hit.step)]);
}

}  // namespace

bool hit_row(const HitRow& row, const std::function<const Texture*()>& picture) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{ImGui::GetContentRegionAvail().x - px(8), row_height()};
  const bool clicked = list_row(row.name, size, row.selected);
  const std::string second = step_text(row);
  controls().record(row.name, fmt::format("{} / {} / {}", row.lesson.title, second, row.hit.around));
  if (row.selected && row.reveal) ImGui::SetScrollHereY();
  if (!ImGui::IsItemVisible()) return clicked;
  const Palette& p = palette();
  auto& list = *ImGui::GetWindowDrawList();
  const ImVec2 inside{at.x + px(row_inset) / 2, at.y + px(row_inset) / 2};
  list.AddRectFilled(inside, {inside.x + px(picture_side), inside.y + px(picture_side)}, colour_u32(p.panel));
  if (const Texture* small = picture(); small && !small->empty())
    draw_tile_picture(list, *small, inside, {inside.x + px(picture_side), inside.y + px(picture_side)});
  const float left = inside.x + px(picture_side) + px(12), room = at.x + size.x - left - px(row_inset);
  float y = inside.y;
  {
    const FontScope bold(Face::bold);
    const std::string title = whole_words(row.lesson.title, room - px(24));
    draw_lines({left, y}, title, p.text);
    if (row.ticked) draw_tick({left + text_width(title) + px(4), y}, theme().font(Face::bold)->FontSize);
  }
  y += line_of(Face::bold);
  draw_lines({left, y}, whole_words(second, room), p.text);
  y += line_of(Face::body) + px(1);
  draw_marked(list, {left, y}, in_lines(row.hit.around, room), row.hit.marked);
  return clicked;
}

}  // namespace ps::gui
