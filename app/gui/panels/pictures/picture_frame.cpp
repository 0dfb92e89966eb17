#include "gui/panels/pictures/picture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "gui/panels/pictures/clipped_text.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr double narrow_below = 380;  ///< pictures below this width, at scale 1, get two lines above and below

const std::vector<Choice>& channel_choices() {
  static const std::vector<Choice> choices = [] {
    std::vector<Choice> result;
    for (const auto& row : shown_channels()) result.push_back({row.key, row.label, row.help});
    return result;
  }();
  return choices;
}

/// Cuts at a space so that the first part fits the width; answers the rest.
std::string take_line(Face face, std::string& text, float width) {
  const FontScope font(face);
  const std::size_t length = in_lines(text, width).find('\n');
  if (length == std::string::npos) return {};
  std::string rest = text.substr(length + 1);
  text.resize(length);
  return rest;
}

}  // namespace

PictureMargins picture_margins(float width, PictureCaptions captions) {
  if (captions == PictureCaptions::brief) return {px(19), px(20)};
  const float notes = px(note_height);
  return width < px(narrow_below) ? PictureMargins{px(66), px(46) + notes} : PictureMargins{px(34), px(26) + notes};
}

std::optional<Area> picture_note(const Area& footer, PictureCaptions captions) {
  if (captions == PictureCaptions::brief) return {};
  return Area{{footer.min.x, footer.min.y + px(3)}, {footer.max.x, footer.min.y + px(note_height)}};
}

void attention_mark(ImDrawList& list, ImVec2 corner, float size) {
  const ImVec2 top{corner.x + size / 2, corner.y}, left{corner.x, corner.y + size},
      right{corner.x + size, corner.y + size};
  list.AddTriangleFilled(top, right, left, colour_u32(palette().attention));
  list.AddTriangle(top, right, left, colour_u32(palette().text), px(1.2));
}

void side_badge(ImDrawList& list, ImVec2 corner, float size, Side side) {
  const ImVec2 end{corner.x + size, corner.y + size};
  list.AddRectFilled(corner, end, colour_u32(palette().field), px(3));
  side_bar(list, {corner.x, end.y - px(4)}, end, side);
  const char text[2] = {letter_of(side), 0};
  ImFont* font = theme().font(Face::bold);
  const float height = font->FontSize;
  const ImVec2 extent = font->CalcTextSizeA(height, FLT_MAX, 0, text);
  list.AddText(font, height, {corner.x + (size - extent.x) / 2, corner.y + (size - px(4) - extent.y) / 2},
               colour_u32(palette().text), text);
}

void picture_title(Session& session, Side side, const Area& row, PictureCaptions captions, std::string_view instead) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  auto& list = *ImGui::GetWindowDrawList();
  const bool is_narrow = row.width() < px(narrow_below), two_lines = is_narrow && captions == PictureCaptions::full;
  const bool has_choice = captions == PictureCaptions::full;  // a brief line has no room for it
  const float line = two_lines ? row.height() - ImGui::GetFrameHeight() - px(3) : row.height();
  const float size = std::min(px(22), line), top = row.min.y + (line - size) / 2;
  const std::string_view channel = channel_choices()[static_cast<std::size_t>(session.shown(side))].label;
  const float channel_room = std::max(px(136), text_width(channel) + px(34));  // with the arrow of the list
  const float choice_width = has_choice ? std::min(channel_room, row.width() * (two_lines ? 0.7f : 0.45f)) : 0,
              space = px(8);
  side_badge(list, {row.min.x, top}, size, side);

  const auto file = side == Side::b ? session.picture_b() : nullptr;
  const CompareMode compare = session.document().compare;
  const bool single = compare == CompareMode::only_a || compare == CompareMode::only_b;
  const Settings* other = single || session.picture_b() ? nullptr : &session.settings(other_side(side));
  const std::string text = !instead.empty() ? std::string(instead)
                           : file           ? "file " + std::filesystem::path(file->path).filename().string()
                                            : title_text(session.settings(side), session.traits(), other);
  const ImU32 colour = colour_u32(palette().text);
  const float text_left = row.min.x + size + space;
  const float text_top = top + (size - theme().font(Face::bold)->FontSize) / 2;
  if (two_lines) {
    const float room = row.max.x - text_left;
    const Face face = width_of(Face::bold, text) <= room ? Face::bold : Face::small;
    std::string first = text;
    const std::string rest = take_line(face, first, room);
    const float first_top = rest.empty() ? text_top : row.min.y;
    clipped_text(list, face, {text_left, first_top}, room, colour, first);
    clipped_text(list, face, {text_left, first_top + px(15)}, room, colour, whole_parts(face, rest, room));
  } else {
    const float room = row.max.x - choice_width - space - text_left;
    std::string shown = whole_parts(Face::bold, text, room);
    const bool fits = width_of(Face::bold, shown) <= room;
    if (!fits) shown = whole_parts(Face::small, text, room);
    if (fits || width_of(Face::small, shown) <= room)  // else the badge and the tooltip alone
      clipped_text(list, fits ? Face::bold : Face::small, {text_left, text_top}, room, colour, shown);
  }

  ImGui::SetCursorScreenPos(row.min);
  ImGui::InvisibleButton(side == Side::a ? "title-a" : "title-b",
                         {std::max(row.width() - choice_width - space, 1.f), row.height()});
  controls().record("title", text);
  tooltip(text + "\nDouble-click: this picture fills the window, and back.");
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    session.navigate([&](Document& document) {
      const CompareMode alone = side == Side::a ? CompareMode::only_a : CompareMode::only_b;
      const bool filled = document.compare == alone && !document.layout.panels;
      document.compare = filled ? CompareMode::side_by_side : alone;
      document.layout.panels = filled;
    });

  if (!has_choice) return;
  const float choice_room = two_lines ? ImGui::GetFrameHeight() + px(6) : line;
  ImGui::SetCursorScreenPos({row.max.x - choice_width, row.max.y - (choice_room + ImGui::GetFrameHeight()) / 2});
  int shown = static_cast<int>(session.shown(side));
  if (choice("show", channel_choices(), shown,
             {.tooltip = "What this picture shows.", .disabled = {}, .width = choice_width}))
    session.edit(fmt::format("{} shows {}", letter_of(side), channel_choices()[static_cast<std::size_t>(shown)].label),
                 [&](Document& document) { side_of(document, side).show = static_cast<ShownChannel>(shown); });
}

}  // namespace ps::gui
