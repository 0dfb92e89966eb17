#include "gui/panels/pictures/left_out_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gui/panels/pictures/picture_frame.h"
#include "gui/theme/theme.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "render/left_out.h"

namespace ps::gui {
namespace {

constexpr double room_for_others = 128;  ///< of the row, at scale 1
constexpr double mark_size = 11, item_gap = 6;

/// Width of the first `count` buttons.
float width_of_buttons(const LeftOut& one, std::size_t count) {
  float width = 0;
  for (std::size_t i = 0; i < count; ++i) width += button_width(one.remedies[i].label) + px(item_gap);
  return width;
}

/// The notice with room for all buttons, or what is before its reason with room for one at least; else empty.
std::string text_that_fits(const LeftOut& one, float room) {
  const std::string brief = one.notice.substr(0, one.notice.find(':'));
  const auto fits = [&](const std::string& text, std::size_t buttons) {
    return text_width(text) + px(item_gap) + width_of_buttons(one, buttons) <= room;
  };
  if (fits(one.notice, one.remedies.size())) return one.notice;
  return fits(brief, std::min<std::size_t>(one.remedies.size(), 1)) ? brief : std::string();
}

/// One thing that is left out, from `at` on; answers where the next may begin, or nullopt where there was no room.
std::optional<float> notice(Session& session, Side side, const LeftOut& one, ImVec2 at, float right, float height) {
  const float room = right - at.x - px(mark_size + item_gap);
  const std::string text = text_that_fits(one, room);
  if (text.empty() && (one.remedies.empty() || button_width(one.remedies.front().label) > room)) return {};
  attention_mark(*ImGui::GetWindowDrawList(), {at.x, at.y + (height - px(mark_size)) / 2}, px(mark_size));
  float x = at.x + px(mark_size + item_gap);
  if (!text.empty()) {
    draw_text({x, at.y}, {x + text_width(text), at.y + height}, text, palette().text, 0);
    x += text_width(text) + px(item_gap);
  }
  for (const Remedy& remedy : one.remedies) {
    if (x + button_width(remedy.label) > right) break;
    ImGui::SetCursorScreenPos({x, at.y + (height - ImGui::GetFrameHeight()) / 2});
    if (button("remedy/" + remedy.setting, remedy.label, Emphasis::plain,
               {.tooltip = fmt::format("{}\nSets {} in {}.", one.sentence, remedy.setting, letter_of(side))}))
      session.edit(fmt::format("{} {}", letter_of(side), remedy.setting),
                   [&](Document& document) { parse_assignment(remedy.setting, side_of(document, side).settings); });
    x += button_width(remedy.label) + px(item_gap);
  }
  return x;
}

}  // namespace

LeftOutTexts left_out_texts(const std::vector<LeftOut>& all) {
  LeftOutTexts texts;
  std::vector<LeftOutBrief> briefs;
  for (const LeftOut& one : all) {
    briefs.push_back(one.brief);
    texts.sentences += (texts.sentences.empty() ? "" : "\n") + one.sentence;
  }
  texts.names = fmt::format("{}", fmt::join(briefs_together(briefs), ", "));
  return texts;
}

Area left_out_line(Session& session, Side side, const Area& row) {
  if (session.file_of(side)) return row;
  const std::vector<LeftOut> all = left_out(session.traits(), session.settings(side));
  if (all.empty()) return row;
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  const FontScope font(Face::small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {px(6), px(1)});
  const LeftOutTexts texts = left_out_texts(all);
  const float right = std::max(row.min.x, row.max.x - px(room_for_others));
  float x = row.min.x;
  std::size_t shown = 0;
  for (const LeftOut& one : all) {
    const bool last = &one == &all.back();
    const std::optional<float> next =
        notice(session, side, one, {x, row.min.y}, last ? right : right - px(28), row.height());
    if (!next) break;
    x = *next + px(item_gap);
    ++shown;
  }
  if (shown < all.size()) {
    std::string more = fmt::format("+{}", all.size() - shown);
    if (shown == 0) {  // its words alone
      attention_mark(*ImGui::GetWindowDrawList(), {x, row.middle().y - px(mark_size) / 2}, px(mark_size));
      x += px(mark_size + item_gap);
      more = whole_parts(texts.names, right - x);
      if (text_width(more) > right - x) more.clear();
    }
    draw_text({x, row.min.y}, {x + text_width(more), row.max.y}, more, palette().text, 0);
    x += text_width(more) + px(item_gap);
  }
  const bool on_a_button = ImGui::IsAnyItemHovered();
  ImGui::SetCursorScreenPos(row.min);
  ImGui::Dummy({std::max(std::min(x, right) - row.min.x, 1.f), row.height()});
  controls().record("left-out", texts.names);
  if (!on_a_button) tooltip(texts.sentences);
  ImGui::PopStyleVar();
  return {{std::min(x, row.max.x), row.min.y}, row.max};
}

}  // namespace ps::gui
