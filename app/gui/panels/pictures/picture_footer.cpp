// The lines below a picture.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gui/panels/pictures/left_out_line.h"
#include "gui/panels/pictures/picture_frame.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/pictures/slow_motion.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/shorten.h"
#include "render/left_out.h"

namespace ps::gui {
namespace {

/// One thing in the line below a picture.
struct FooterItem {
  std::string name;  ///< for scripts; may be empty
  std::string text;
  std::string tooltip;
  enum class Voice { quiet, plain, attention } voice = Voice::quiet;
  std::string changed = {};  ///< in place of the text: with what it was before
  std::string widest = {};   ///< a text of the most room that it takes; empty = its text
};
using Voice = FooterItem::Voice;
constexpr const char* time_name = "time";
constexpr const char* beside_help = "Pixels whose levels are not those of A.";

FooterItem left_out_item(Session& session, Side side) {
  const LeftOutTexts texts = left_out_texts(left_out(session.traits(), session.settings(side)));
  return {"left-out", texts.names, texts.sentences, Voice::attention};
}

/// The median of warm runs; a single run would say more about what it had to prepare.
FooterItem time_item(Session& session, const RenderResult& result) {
  const TimedPicture* timed = session.work().timed().find(result.request);
  if (!timed) return {};
  return {time_name, warm_time_text(timed->ms),
          fmt::format("Median and quartiles of {} warm runs, in turn with the other picture.", timed->runs),
          Voice::plain};
}

std::vector<FooterItem> footer_items(Session& session, Side side, CaptionChange& change, PictureCaptions captions,
                                     const std::string& lead, const std::string& beside) {
  if (const auto file = session.file_of(side))
    return {{{}, fmt::format("{}{} x {} pixels", lead, file->levels.width(), file->levels.height()), file->path},
            {"beside", beside, beside.empty() ? "" : beside_help, Voice::plain}};
  const auto result = session.renderer(side).result();
  if (const std::string words = slow_words(session, side); !words.empty()) {
    if (session.document().mode == ScreenMode::presenter) return {};  // they are in large type in the strip
    return {{"slow", lead + words, words}};
  }
  const double now = ImGui::GetTime();
  change.take(result, now);
  std::vector<FooterItem> items;
  if (const std::string state = state_text(session.renderer(side).status(), result.get()); !state.empty()) {
    items.push_back({{}, state, {}});
  } else {
    const std::string counters = counters_text(*result);
    for (const CaptionWork& work : caption_work(*result)) {
      FooterItem item{{}, work_text(work), counters, work.attention ? Voice::attention : Voice::plain};
      if (const auto before = change.before(work, now)) item.changed = work_text(work, before);
      item.widest = work_text(work, work.count);
      items.push_back(std::move(item));
    }
    if (!beside.empty()) items.push_back({"beside", beside, beside_help, Voice::plain});
    items.push_back(time_item(session, *result));
  }
  // After the pixels that are not a number, which no ellipsis may reach.
  const auto place =
      std::find_if(items.begin(), items.end(), [](const FooterItem& item) { return item.voice != Voice::attention; });
  if (captions != PictureCaptions::full) items.insert(place, left_out_item(session, side));
  std::erase_if(items, [](const FooterItem& item) { return item.text.empty(); });
  if (!lead.empty() && !items.empty()) {
    items.front().text = lead + items.front().text;
    if (!items.front().changed.empty()) items.front().changed = lead + items.front().changed;
  }
  return items;
}

struct FooterMeasures {
  Face face = Face::small;
  float between = px(14), mark = px(11), height = theme().font(face)->FontSize + px(3);
  float inset(const FooterItem& item) const { return item.voice == Voice::attention ? mark + px(5) : 0; }
  float width(const FooterItem& item, const std::string& text) const { return inset(item) + text_width(text, face); }
};

/// Where each item begins, and its room.
struct Slot {
  ImVec2 at;
  float width = 0;
};

/// The items in lines, one after the other; nullopt if they need more lines than there are.
std::optional<std::vector<Slot>> in_slots(const std::vector<float>& widths, const Area& row,
                                          const FooterMeasures& measures) {
  std::vector<Slot> slots;
  ImVec2 at = row.min;
  for (const float width : widths) {
    if (at.x > row.min.x && at.x + width > row.max.x) at = {row.min.x, at.y + measures.height};
    if (at.x + width > row.max.x || at.y + measures.height > row.max.y + px(2)) return {};
    slots.push_back({at, width});
    at.x += width + measures.between;
  }
  return slots;
}

/// So that nothing moves when the old counts come and go, room is kept for them. Where that is too much, they take the
/// room that they need, if need be that of the time, the first of them rather than all. Where even that is too much,
/// what comes last is cut.
std::vector<Slot> placed(std::vector<FooterItem>& items, const Area& row, const FooterMeasures& measures) {
  enum class Room { kept, needed };
  const auto widths = [&](Room room) {
    std::vector<float> all;
    for (const FooterItem& item : items) {
      const float now = measures.width(item, item.changed.empty() ? item.text : item.changed);
      all.push_back(room == Room::kept ? std::max(now, measures.width(item, item.widest)) : now);
    }
    return all;
  };
  const auto any_changed = [&] {
    return std::any_of(items.begin(), items.end(), [](const FooterItem& item) { return !item.changed.empty(); });
  };
  if (const auto slots = in_slots(widths(Room::kept), row, measures)) return *slots;
  if (const auto slots = in_slots(widths(Room::needed), row, measures)) return *slots;
  const std::vector<FooterItem> all_items = items;
  if (any_changed() && items.back().name == time_name) items.pop_back();
  for (std::size_t i = items.size(); i-- > 0 && any_changed(); items[i].changed.clear())
    if (const auto slots = in_slots(widths(Room::needed), row, measures)) return *slots;
  items = all_items;
  std::stable_partition(items.begin(), items.end(), [](const FooterItem& item) {
    return item.voice == Voice::attention || item.name == "beside";  // the counts give way to them
  });
  for (FooterItem& item : items) item.changed.clear();
  std::vector<Slot> slots;
  ImVec2 at = row.min;
  for (const float width : widths(Room::needed)) {
    if (at.x > row.min.x && at.x + width > row.max.x && at.y + 2 * measures.height <= row.max.y + px(2))
      at = {row.min.x, at.y + measures.height};
    slots.push_back({at, std::max(0.f, std::min(width, row.max.x - at.x))});
    at.x += width + measures.between;
  }
  return slots;
}

}  // namespace

void picture_footer(Session& session, Side side, CaptionChange& change, const Area& row, PictureCaptions captions,
                    const std::string& lead, const std::string& beside) {
  const NameScope scope(side == Side::a ? "view/a" : "view/b");
  auto& list = *ImGui::GetWindowDrawList();
  const FooterMeasures measures{.face = captions == PictureCaptions::projected ? Face::caption : Face::small};
  std::vector<FooterItem> items = footer_items(session, side, change, captions, lead, beside);
  const ImVec2 corner{row.min.x, row.min.y + px(3)};
  const float bottom = row.max.y - (captions == PictureCaptions::full ? px(note_height) : 0);
  const std::string time = !items.empty() && items.back().name == time_name ? items.back().text : "";
  const std::vector<Slot> slots = placed(items, {corner, {row.max.x, bottom}}, measures);
  std::string all;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const FooterItem& item = items[i];
    const std::string& text = item.changed.empty() ? item.text : item.changed;
    all += (all.empty() ? "" : "   ") + text;
    const auto [at, width] = slots[i];
    if (width < px(24)) continue;
    if (item.voice == Voice::attention) attention_mark(list, {at.x, at.y + px(2)}, measures.mark);
    // What does not fit is not there at all, but for the first: half a number would be another one.
    const float room = width - measures.inset(item);
    const FontScope font(measures.face);
    const std::string shown = i == 0 ? whole_parts(text, room) : text;
    if (i > 0 && text_width(text) > room + 1) continue;
    const float left = at.x + measures.inset(item);
    draw_text({left, at.y}, {left + room + 1, at.y + ImGui::GetFontSize()}, shown,
              item.voice == Voice::quiet ? palette().text_quiet : palette().text, 0);
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({width, std::min(measures.height, row.max.y - at.y)});
    if (item.name == "left-out" || item.name == "beside") controls().record(item.name, text);
    tooltip(item.tooltip);
  }
  controls().record("footer", row.min, row.max, all);
  controls().record(time_name, row.min, row.max, time);  // also where there is none
  if (const double left = change.left(ImGui::GetTime()); left > 0) redraw_after(left);

  const auto status = session.renderer(side).status();
  if (status.state != RenderState::full || status.fraction <= 0) return;
  const float width = row.width() * static_cast<float>(status.fraction);
  list.AddRectFilled(row.min, {row.min.x + width, row.min.y + px(3)},
                     colour_u32(side == Side::a ? palette().a : palette().b));
}

}  // namespace ps::gui
