#include "gui/widgets/picture_tiles.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr double picture_size = 152, tile_gap = 16;  // at scale 1

int moved_by_keys(int selected, int columns, int count) {
  int moved = selected;
  if (key_pressed(Key::right)) ++moved;
  if (key_pressed(Key::left)) --moved;
  if (key_pressed(Key::down)) moved += columns;
  if (key_pressed(Key::up)) moved -= columns;
  return moved < 0 || moved >= count ? std::clamp(selected, 0, std::max(count - 1, 0)) : moved;
}

void draw_words(ImDrawList& list, const PictureTile& tile, ImVec2 at, ImVec2 end, float line) {
  const FontScope font(Face::small);
  list.PushClipRect(at, end, true);
  const std::string title = in_lines(tile.title, end.x - at.x);
  draw_lines({at.x, at.y + px(4)}, title, palette().text);
  const float y = at.y + px(6) + text_height(title);
  if (tile.ticked) draw_tick({at.x - px(4), y}, line);
  draw_lines({at.x + (tile.ticked ? px(16) : 0), y}, tile.note, palette().text_quiet);
  list.PopClipRect();
}

}  // namespace

void draw_tile_picture(ImDrawList& list, const Texture& picture, ImVec2 min, ImVec2 max) {
  const auto w = static_cast<float>(picture.width()), h = static_cast<float>(picture.height());
  const float fit = std::min((max.x - min.x) / w, (max.y - min.y) / h), scale = fit < 1 ? fit : std::floor(fit);
  const ImVec2 size{w * scale, h * scale};
  picture.set_shrunk(scale < 1);
  const ImVec2 corner{std::round((min.x + max.x - size.x) / 2), std::round((min.y + max.y - size.y) / 2)};
  list.AddImage(picture.id(), corner, {corner.x + size.x, corner.y + size.y});
}

int tile_picture_size() { return static_cast<int>(px(picture_size)); }

PictureTiles::PictureTiles(int& selected, std::size_t count, const TileLook& look) : look_(look) {
  const float room = ImGui::GetContentRegionAvail().x - px(8);
  columns_ = std::max(1, static_cast<int>((room + px(tile_gap)) / px(picture_size + tile_gap)));
  const int before = selected;
  selected = selected_ = moved_by_keys(selected, columns_, static_cast<int>(count));
  reveal_ = look.reveal || selected != before;
}

void PictureTiles::heading(const std::string& text) {
  column_ = 0;
  ImGui::Dummy({0, px(4)});
  show_text(text, {Face::bold});
  ImGui::Dummy({0, px(2)});
}

bool PictureTiles::tile(const PictureTile& tile) {
  if (column_ > 0) ImGui::SameLine(static_cast<float>(column_) * px(picture_size + tile_gap) + px(6));
  if (column_ == 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(6));
  column_ = (column_ + 1) % columns_;
  const bool selected = number_++ == selected_;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = theme().font(Face::small)->FontSize + px(3);
  const ImVec2 size{px(picture_size), px(picture_size) + static_cast<float>(look_.lines) * line + px(6)};
  const bool clicked = ImGui::InvisibleButton(tile.name.c_str(), size);
  controls().record(tile.name, tile.note.empty() ? tile.title : tile.title + ", " + tile.note);
  if (selected && reveal_) ImGui::SetScrollHereY();
  if (!ImGui::IsItemVisible()) return clicked;
  auto& list = *ImGui::GetWindowDrawList();
  const Palette& p = palette();
  const ImVec2 end{at.x + size.x, at.y + size.y}, picture_end{end.x, at.y + px(picture_size)};
  if (selected || ImGui::IsItemHovered())
    list.AddRectFilled({at.x - px(5), at.y - px(5)}, {end.x + px(5), end.y + px(3)},
                       colour_u32(selected ? p.selection : p.field_hover), px(4));
  list.AddRectFilled(at, picture_end, colour_u32(p.panel));
  if (const Texture* picture = tile.picture(tile_picture_size(), tile_picture_size()); picture && !picture->empty())
    draw_tile_picture(list, *picture, at, picture_end);
  draw_words(list, tile, {at.x, picture_end.y}, end, line);
  tooltip(tile.tooltip);
  return clicked;
}

}  // namespace ps::gui
