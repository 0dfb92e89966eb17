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

constexpr double title_distance = 8, brief_distance = 3;  ///< from a title to its picture, at scale 1
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

/// Parts of a title: the letter's badge, and the list of channels, if it has one.
struct TitleMeasures {
  float badge = 0, space = 0;
  bool two_lines = false;  ///< the list has a line of its own
  float choice = 0;        ///< the width of the list; 0 = none, as a brief line has no room for it
};
/// `height`: of the row.
TitleMeasures title_measures(Session& session, Side side, float height, PictureCaptions captions) {
  const double badge = captions == PictureCaptions::projected ? 30 : captions == PictureCaptions::brief ? 18 : 22;
  TitleMeasures measures{.badge = px(badge), .space = px(8)};
  if (captions != PictureCaptions::full) return measures;
  measures.two_lines = height > 2 * ImGui::GetFrameHeight();
  const std::string_view channel = channel_choices()[static_cast<std::size_t>(session.shown(side))].label;
  measures.choice = std::max(px(136), text_width(channel) + px(34));  // with the arrow of the list
  return measures;
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
  if (const auto file = session.file_of(side)) {
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
  if (captions == PictureCaptions::projected) return {px(38), px(32)};
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
  const FontScope bold(size < px(20) ? Face::small_bold : Face::bold);
  const std::string letter(1, letter_of(side));
  const ImVec2 room{size - text_width(letter), size - px(4) - ImGui::GetFontSize()};
  draw_lines({corner.x + room.x / 2, corner.y + room.y / 2}, letter, palette().text);
}

Halves over_parts(const Area& row, const Area& place, float at, float left, float right, float gap) {
  const float space = gap / 2;
  left = std::min(left, place.width() / 2 - space);
  right = std::min(right, place.width() / 2 - space);
  const float middle = std::clamp(at, place.min.x + left + space, place.max.x - right - space);
  return {{{std::min(row.min.x, middle - space - left), row.min.y}, {middle - space, row.max.y}},
          {{middle + space, row.min.y}, {std::max(row.max.x, middle + space + right), row.max.y}}};
}

float title_width(Session& session, Side side, float height, PictureCaptions captions) {
  const TitleMeasures measures = title_measures(session, side, height, captions);
  const float words = measures.badge + measures.space +
                      text_width(shown_title(session, side).differing, title_faces(captions).large) + px(12);
  if (measures.two_lines) return std::max(words, measures.choice);
  return words + (measures.choice > 0 ? measures.choice + measures.space : 0);
}

void picture_title(Session& session, Side side, const Area& row, PictureCaptions captions, std::string_view instead) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  const TitleMeasures measures = title_measures(session, side, row.height(), captions);
  const auto [size, space, two_lines, wanted_choice] = measures;
  const bool has_choice = wanted_choice > 0;
  const float choice_width = std::min(wanted_choice, row.width() * (two_lines ? 0.7f : 0.45f));
  const float frame = ImGui::GetFrameHeight(),
              above = px(captions == PictureCaptions::brief ? brief_distance : title_distance);
  const float top = row.max.y - above - size - (two_lines ? frame + px(4) : 0);
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
  const float choice_top = two_lines ? row.max.y - above - frame : top - (frame - size) / 2;
  ImGui::SetCursorScreenPos({row.max.x - choice_width, choice_top});
  int shown = static_cast<int>(session.shown(side));
  if (choice("show", channel_choices(), shown, {.tooltip = "What this picture shows.", .width = choice_width}))
    session.edit(fmt::format("{} shows {}", letter_of(side), channel_choices()[static_cast<std::size_t>(shown)].label),
                 [&](Document& document) { side_of(document, side).show = static_cast<ShownChannel>(shown); });
}

}  // namespace ps::gui
