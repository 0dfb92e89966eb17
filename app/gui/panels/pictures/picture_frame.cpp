#include "gui/panels/pictures/picture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "document/technique.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"

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

/// The faces of a title and of the line below a picture.
struct TitleFaces {
  Face large, low;
};
TitleFaces title_faces(PictureCaptions captions) {
  return captions == PictureCaptions::projected ? TitleFaces{Face::caption, Face::caption}
                                                : TitleFaces{Face::bold, Face::small};
}

/// A title in its room: what differs in bold, if need be in small type or as values alone; then the rest, quietly.
void draw_title(const PictureTitle& title, ImVec2 at, float room, PictureCaptions captions) {
  const auto [large, low] = title_faces(captions);
  const auto fits = [&](Face face, const std::string& text) { return text_width(text, face) <= room; };
  const bool whole = fits(large, title.differing) || fits(low, title.differing);
  const std::string& words = whole || title.brief.empty() ? title.differing : title.brief;
  const ImVec2 end{at.x + room, at.y + theme().font(large)->FontSize};
  float used = px(12);
  {
    const FontScope font(fits(large, words) ? large : low);
    draw_text(at, end, whole_parts(words, room), palette().text, 0);
    used += text_width(words);
  }
  const float left = room - used;
  if (title.shared.empty() || left < px(40)) return;
  const FontScope small(low);
  const std::string rest = whole_parts(title.shared, left);
  if (text_width(rest) <= left)
    draw_text({at.x + used, at.y + px(1)}, {end.x, end.y + px(1)}, rest, palette().text_quiet, 0);
}

}  // namespace

PictureTitle shown_title(Session& session, Side side) {
  if (const auto file = side == Side::b ? session.picture_b() : nullptr) {
    const std::string name = "file " + std::filesystem::path(file->path).filename().string();
    return {name, name, {}};
  }
  const CompareMode compare = session.document().compare;
  const bool single = compare == CompareMode::only_a || compare == CompareMode::only_b;
  const Settings* other = single || session.picture_b() ? nullptr : &session.settings(other_side(side));
  PictureTitle title = picture_title_words(session.settings(side), session.traits(), other);
  if (const auto shown = session.shown_technique(); other && shown)
    title.differing = title.brief = technique_words(session.document(), *shown)[index_of(side)];
  return title;
}

PictureMargins picture_margins(float width, PictureCaptions captions) {
  if (captions == PictureCaptions::brief) return {px(21), px(20)};
  if (captions == PictureCaptions::projected) return {px(36), px(32)};
  const float notes = px(note_height);
  return width < px(narrow_below) ? PictureMargins{px(66), px(46) + notes} : PictureMargins{px(34), px(26) + notes};
}

std::optional<Area> picture_note(const Area& footer, PictureCaptions captions) {
  if (captions != PictureCaptions::full) return {};
  return Area{{footer.min.x, footer.max.y - px(note_height)}, {footer.max.x, footer.max.y - px(3)}};
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
  const FontScope bold(Face::bold);
  const std::string letter(1, letter_of(side));
  const ImVec2 room{size - text_width(letter), size - px(4) - ImGui::GetFontSize()};
  draw_lines({corner.x + room.x / 2, corner.y + room.y / 2}, letter, palette().text);
}

void picture_title(Session& session, Side side, const Area& row, PictureCaptions captions, std::string_view instead) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  const bool is_narrow = row.width() < px(narrow_below), two_lines = is_narrow && captions == PictureCaptions::full;
  const bool has_choice = captions == PictureCaptions::full;  // a brief line has no room for it
  const float line = two_lines ? row.height() - ImGui::GetFrameHeight() - px(3) : row.height();
  const float size = std::min(px(captions == PictureCaptions::projected ? 30 : 22), line),
              top = row.min.y + (line - size) / 2;
  const std::string_view channel = channel_choices()[static_cast<std::size_t>(session.shown(side))].label;
  const float channel_room = std::max(px(136), text_width(channel) + px(34));  // with the arrow of the list
  const float choice_width = has_choice ? std::min(channel_room, row.width() * (two_lines ? 0.7f : 0.45f)) : 0,
              space = px(8);
  side_badge(*ImGui::GetWindowDrawList(), {row.min.x, top}, size, side);

  PictureTitle words = shown_title(session, side);
  if (!instead.empty()) words = {std::string(instead), {}, {}};
  const std::string text = words.text();
  const float text_left = row.min.x + size + space;
  const float text_top = top + (size - theme().font(title_faces(captions).large)->FontSize) / 2;
  draw_title(words, {text_left, text_top}, row.max.x - text_left - (two_lines ? 0 : choice_width + space), captions);

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
  if (choice("show", channel_choices(), shown, {.tooltip = "What this picture shows.", .width = choice_width}))
    session.edit(fmt::format("{} shows {}", letter_of(side), channel_choices()[static_cast<std::size_t>(shown)].label),
                 [&](Document& document) { side_of(document, side).show = static_cast<ShownChannel>(shown); });
}

}  // namespace ps::gui
