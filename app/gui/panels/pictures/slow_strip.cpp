#include "gui/panels/pictures/slow_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/input/key_hint.h"
#include "gui/panels/pictures/marks.h"
#include "gui/panels/pictures/picture_frame.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"
#include "render/slow_motion.h"

namespace ps::gui {
namespace {

constexpr const char* order_words =
    "In the order of the clear path on one thread. A and B are at the same share of their work, "
    "and where they count the same, at the same number.";
constexpr const char* order_note = "clear path, one thread";
constexpr double knob = 7, least_scrubber = 120, good_scrubber = 200;

bool presents(const Session& session) { return session.document().mode == ScreenMode::presenter; }

/// Before a class all words are as large as the lesson's caption.
Face strip_face(const Session& session) { return presents(session) ? Face::caption : Face::body; }

/// Width of the list of units: the longest has room in it.
float unit_width(const Session& session) {
  constexpr double arrow = 32;  // at scale 1, with the space around the word
  float widest = 0;
  for (const SlowUnitRow& row : slow_units()) widest = std::max(widest, text_width(row.label, strip_face(session)));
  return widest + px(arrow);
}

/// What a side counts, or that it shows all, in a list that is at most so wide.
void unit_choice(Session& session, Side side, float widest) {
  std::vector<Choice> choices{{"whole", "Whole", "The finished picture."}};
  std::vector<std::string_view> idle{""};
  const auto& motion = side_of(session.document(), side).slow_motion;
  int index = 0;
  for (const SlowUnitRow& row : slow_units()) {
    if (motion && motion->unit == row.unit) index = static_cast<int>(choices.size());
    choices.push_back({row.key, row.label, row.help});
    idle.push_back(slow_motion_lacks(row.unit, session.settings(side), session.traits()).value_or(""));
  }
  const std::string tip = fmt::format("What {} counts.", letter_of(side));
  const float own = unit_width(session), width = std::min(own, widest);
  const Face face = width < own ? Face::small : strip_face(session);
  if (!drop_down(side == Side::a ? "slow/unit-a" : "slow/unit-b", choices, index, width,
                 {.tooltip = tip, .idle = [&idle](std::size_t unit) { return std::string(idle[unit]); }},
                 {.face = face}))
    return;
  if (!idle[static_cast<std::size_t>(index)].empty()) return;
  std::optional<SlowMotion> next;
  if (index > 0) next = SlowMotion{slow_units()[static_cast<std::size_t>(index) - 1].unit, all_slow_units};
  session.navigate([&](Document& document) { side_of(document, side).slow_motion = next; });
}

/// Answers the share that the mouse asks for.
void scrubber(Session& session, SlowMotionState& state, float width) {
  const float height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("scrub", {width, height});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const float left = at.x + px(knob), room = std::max(1.f, width - 2 * px(knob));
  const double share = state.wanted.value_or(slow_share(session));
  if (active) {
    state.playing = false;
    const double wanted = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - left) / room), 0.0, 1.0);
    if (std::abs(wanted - share) * room > 0.25) state.wanted = wanted;
  }
  state.held = active;
  if (hovered && ImGui::GetIO().MouseWheel != 0)
    step_slow_motion(session, state, ImGui::GetIO().MouseWheel > 0 ? 1 : -1);
  controls().record("slow/scrub", at, {at.x + width, at.y + height}, fmt::format("{:.4f}", share));
  tooltip(order_words);
  auto& list = *ImGui::GetWindowDrawList();
  const float y = std::round(at.y + height / 2), x = left + static_cast<float>(share) * room;
  list.AddRectFilled({left, y - px(2)}, {left + room, y + px(2)}, colour_u32(palette().text, 0.25f), px(2));
  list.AddRectFilled({left, y - px(2)}, {x, y + px(2)}, colour_u32(palette().text, 0.8f), px(2));
  list.AddCircleFilled({x, y}, px(active || hovered ? knob : knob - 1), colour_u32(palette().text));
}

/// What the strip holds: in little width only what has no key.
enum class StripForm { full, without_steps, one_unit };

struct StripWidths {
  float badge = 0, unit = 0, rest = 0;  ///< rest: all but the scrubber
};

StripWidths strip_widths(const Session& session, StripForm form) {
  const float space = px(6);
  StripWidths widths;
  widths.badge = ImGui::GetFrameHeight() * 0.7f;
  widths.unit = unit_width(session) + widths.badge + 2 * space;
  widths.rest = std::max(button_width("Play"), button_width("Pause")) + 2 * space;
  widths.rest += widths.unit * (form == StripForm::one_unit ? 1 : 2);
  widths.rest += form == StripForm::full
                     ? button_width("-1") + button_width("+1") + px(2) + space + button_width("Close")
                     : button_width("×");
  return widths;
}

StripForm strip_form(const Session& session, float width) {
  for (const StripForm form : {StripForm::full, StripForm::without_steps})
    if (strip_widths(session, form).rest + px(least_scrubber) <= width) return form;
  return StripForm::one_unit;
}

/// Before a class: how far each picture has come, in place of the small print below it.
void places_in_words(Session& session) {
  auto& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  for (const Side side : both_sides) {
    const std::string words = slow_words(session, side);
    if (words.empty()) continue;
    const ImVec2 corner{at.x + (side == Side::a ? 0 : width / 2), at.y};
    const float left = corner.x + height + px(8), room = width / 2 - height - px(16);
    side_badge(list, corner, height, side);
    // The number alone where there is no room for what it was.
    const bool fits = text_width(words) <= room;
    const std::string shown = fits ? words : whole_words(words.substr(0, words.find(": ")), room);
    draw_lines({left, at.y}, shown, palette().text);
    controls().record(side == Side::a ? "slow/place-a" : "slow/place-b", {left, at.y},
                      {left + text_width(shown), at.y + height}, shown);
  }
  ImGui::Dummy({width, height});
}

}  // namespace

float slow_strip_height(const Session& session) {
  if (!slow_motion_open(session)) return 0;
  const float words = theme().font(strip_face(session))->FontSize;
  const float line = presents(session) ? words + ImGui::GetStyle().ItemSpacing.y : 0;
  return line + words + 2 * ImGui::GetStyle().FramePadding.y + px(6);
}

void slow_strip(Session& session, SlowMotionState& state) {
  const FontScope font(strip_face(session));
  if (presents(session)) places_in_words(session);
  const float space = px(6), width = ImGui::GetContentRegionAvail().x;
  const StripForm form = strip_form(session, width);
  const StripWidths widths = strip_widths(session, form);
  if (button("slow/play", state.playing ? "Pause" : "Play", Emphasis::plain,
             {.tooltip = "Plays the drawing of both pictures, or stops it (Space)."}))
    play_slow_motion(session, state);
  ImGui::SameLine(0, space);
  if (form == StripForm::full) {
    if (button("slow/back", "-1", Emphasis::quiet, {.tooltip = "One back in the picked picture (comma)."}))
      step_slow_motion(session, state, -1);
    ImGui::SameLine(0, px(2));
    if (button("slow/forward", "+1", Emphasis::quiet, {.tooltip = "One on in the picked picture (full stop)."}))
      step_slow_motion(session, state, 1);
    ImGui::SameLine(0, space);
  }
  const float room = width - widths.rest, note = text_width(order_note, Face::small) + space;
  const bool has_note = !presents(session) && room - note >= px(good_scrubber);
  scrubber(session, state, std::max(px(2 * knob), has_note ? room - note : room));
  if (has_note) {
    ImGui::SameLine(0, space);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{note - space, ImGui::GetFrameHeight()};
    draw_text(at, {at.x + size.x, at.y + size.y}, order_note, palette().text_quiet, 0, Face::small);
    ImGui::Dummy(size);
    controls().record("slow/order", order_note);
    tooltip(order_words);
  }
  for (const Side side : both_sides) {
    if (form == StripForm::one_unit && side != session.document().picked) continue;
    ImGui::SameLine(0, space);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    side_badge(*ImGui::GetWindowDrawList(), {at.x, at.y + (ImGui::GetFrameHeight() - widths.badge) / 2}, widths.badge,
               side);
    ImGui::SetCursorScreenPos({at.x + widths.badge + space, at.y});
    const float after = button_width(form == StripForm::full ? "Close" : "×") + 2 * space;
    const bool last = form == StripForm::one_unit || side == Side::b;
    unit_choice(session, side, last ? ImGui::GetContentRegionAvail().x - after : unit_width(session));
  }
  ImGui::SameLine(0, space);
  if (button("slow/close", form == StripForm::full ? "Close" : "×", Emphasis::quiet,
             {.tooltip = with_key("Shows the finished pictures again.", "slow-motion")}))
    toggle_slow_motion(session, state);
}

void slow_mark(ImDrawList& list, const SlowState& state, const PictureTransform& transform, const Area& area) {
  const auto place = [&](const Vec2d& point) { return transform.to_window(point, area); };
  for (const auto& triangle : state.outline)
    light_on_dark(false, [&](ImU32 colour, float thickness) {
      list.AddTriangle(place(triangle[0]), place(triangle[1]), place(triangle[2]), colour, thickness);
    });
  std::optional<TileRect> box = state.box;
  if (state.pixel) box = TileRect{state.pixel->x, state.pixel->y, state.pixel->x + 1, state.pixel->y + 1};
  if (!box) return;
  const ImVec2 low = place({box->x0, box->y0}), high = place({box->x1, box->y1});
  light_on_dark(false, [&](ImU32 colour, float thickness) {
    list.AddRect({low.x - px(2), low.y - px(2)}, {high.x + px(2), high.y + px(2)}, colour, 0, 0, thickness);
  });
}

}  // namespace ps::gui
