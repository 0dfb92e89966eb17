#include "gui/panels/lesson/claim_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/metric_words.h"
#include "gui/panels/lesson/lesson_list.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double mark_room = 22;

std::vector<ClaimButton> buttons_of(const LessonClaims& claims, std::size_t claim) {
  std::vector<ClaimButton> buttons;
  if (claims.shown(claim) == ClaimShown::mutation) return {{"mend", "Back", ClaimShown::step}};
  if (claims.shown(claim) == ClaimShown::claim)
    buttons.push_back({"leave", "Back", ClaimShown::step});
  else if (changes_anything(claims.claims().at(claim).own))
    buttons.push_back({"show", "Show it", ClaimShown::claim});
  buttons.push_back({"break", "Break it", ClaimShown::mutation});
  return buttons;
}

float buttons_width(const std::vector<ClaimButton>& buttons) {
  float width = 0;
  for (const ClaimButton& each : buttons) width += button_width(each.label) + px(6);
  return width;
}

/// "Pixels that differ: 41,231, claimed: at least 1,000."
std::string sentence(const LessonClaims& claims, std::size_t claim) {
  const Claim& of = claims.claims().at(claim);
  const Metric& metric = claims.metric(claim);
  std::string what = metric_words(metric);
  what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  const auto value = claims.value(claim);
  std::string text = fmt::format("{}: {}, claimed: {}.", what, value ? value_words(metric, *value) : "...",
                                 demand_words(metric, of.bound));
  if (const std::string trouble = claims.trouble(claim); !trouble.empty()) text += " " + trouble;
  if (claims.shown(claim) == ClaimShown::mutation && !of.mutation.changes_metric)
    text += fmt::format(" Now with {}.", of.mutation.words);
  return text;
}

void draw_cross(ImVec2 row, float height) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = row.x + px(4), y = row.y + height / 2;
  const ImU32 ink = colour_u32(palette().wrong_mark);
  list.AddLine({x, y - px(5)}, {x + px(10), y + px(5)}, ink, px(2.5));
  list.AddLine({x, y + px(5)}, {x + px(10), y - px(5)}, ink, px(2.5));
}

void draw_mark(ImVec2 row, float height, std::optional<bool> holds) {
  if (holds) return *holds ? draw_tick(row, height) : draw_cross(row, height);
  ImGui::GetWindowDrawList()->AddCircle({row.x + px(9), row.y + height / 2}, px(4), colour_u32(palette().text_quiet), 0,
                                        px(1.5));
}

}  // namespace

ClaimLayout lay_out_claim(const LessonClaims& claims, std::size_t claim, float width) {
  ClaimLayout layout;
  layout.width = width;
  if (const auto value = claims.value(claim)) layout.holds = claims.claims().at(claim).bound.holds(*value);
  layout.buttons = buttons_of(claims, claim);
  const float buttons = buttons_width(layout.buttons), room = width - px(mark_room), frame = ImGui::GetFrameHeight();
  {
    const FontScope font(Face::small);
    layout.lines = sentence(claims, claim);
    layout.one_row = text_width(layout.lines) + buttons + px(8) <= room;
    if (!layout.one_row) layout.lines = in_lines(layout.lines, room);
    layout.text_height = text_height(layout.lines);
  }
  layout.height = layout.one_row ? std::max(layout.text_height, frame) : layout.text_height + px(2) + frame;
  return layout;
}

void claim_line(Session& session, LessonClaims& claims, std::size_t claim, const ClaimLayout& layout) {
  const NameScope scope(fmt::format("claim/{}", claim));
  const Claim& of = claims.claims().at(claim);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float frame = ImGui::GetFrameHeight(), row = layout.one_row ? frame : layout.text_height;
  const std::optional<bool>& holds = layout.holds;
  const ImVec2 text{at.x + px(mark_room), std::floor(at.y + (row - layout.text_height) / 2)};
  {
    const FontScope font(Face::small);
    draw_mark(at, layout.one_row ? frame : ImGui::GetTextLineHeight(), holds);
    ImGui::SetCursorScreenPos(text);
    value_text("measured", layout.lines, {.quiet = true});
  }
  tooltip("Measured on what the screen shows, each time that it changes.");
  controls().record("state", at, {at.x + px(mark_room), at.y + row}, !holds ? "open" : *holds ? "holds" : "broken");
  ImVec2 place{at.x + px(mark_room), at.y + layout.text_height + px(2)};
  if (layout.one_row) place = {at.x + layout.width - buttons_width(layout.buttons) + px(6), at.y};
  std::optional<ClaimShown> wanted;
  for (const ClaimButton& each : layout.buttons) {
    ImGui::SetCursorScreenPos(place);
    const std::string help =
        each.leads_to == ClaimShown::mutation
            ? fmt::format("Changes what makes it true: {}. The claim should then not hold.", of.mutation.words)
        : each.leads_to == ClaimShown::claim ? std::string("Puts on the screen what the claim is about.")
                                             : std::string("Puts back what was on the screen before.");
    if (button(each.name, each.label, Emphasis::plain, {.tooltip = help})) wanted = each.leads_to;
    place.x += button_width(each.label) + px(6);
  }
  ImGui::SetCursorScreenPos(at);
  if (wanted) claims.show(session, claim, *wanted);
}

}  // namespace ps::gui
