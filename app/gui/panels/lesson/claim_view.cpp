#include "gui/panels/lesson/claim_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/metric_words.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double mark_room = 22;

struct ClaimButton {
  const char *name, *label;
  ClaimShown leads_to;
};

std::vector<ClaimButton> buttons_of(const LessonClaims& claims, std::size_t claim) {
  const LessonState& own = claims.claims().at(claim).own;
  const bool own_settings = !own.scene.empty() || !own.set_a.empty() || !own.set_b.empty() || !own.parts.empty();
  std::vector<ClaimButton> buttons;
  if (claims.shown(claim) == ClaimShown::mutation) return {{"mend", "Back", ClaimShown::step}};
  if (claims.shown(claim) == ClaimShown::claim)
    buttons.push_back({"leave", "Back", ClaimShown::step});
  else if (own_settings)
    buttons.push_back({"show", "Show it", ClaimShown::claim});
  buttons.push_back({"break", "Break it", ClaimShown::mutation});
  return buttons;
}

float buttons_width(const std::vector<ClaimButton>& buttons) {
  float width = 0;
  for (const ClaimButton& each : buttons) width += button_width(each.label) + px(6);
  return width;
}

/// "Pixels that differ: 41231, claimed: at least 1000."
std::string sentence(const LessonClaims& claims, std::size_t claim) {
  const Claim& of = claims.claims().at(claim);
  std::string what = metric_words(claims.metric(claim));
  what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
  const auto value = claims.value(claim);
  std::string text =
      fmt::format("{}: {}, claimed: {}.", what, value ? measured_text(*value) : "...", bound_words(of.bound));
  if (const std::string trouble = claims.trouble(claim); !trouble.empty()) text += " " + trouble;
  if (claims.shown(claim) == ClaimShown::mutation && !of.mutation.changes_metric)
    text += fmt::format(" Now with {}.", mutation_words(of.mutation));
  return text;
}

struct ClaimLayout {
  std::string lines;
  float text_height = 0;
  bool one_row = false;
};

ClaimLayout layout_of(const LessonClaims& claims, std::size_t claim, float width) {
  const float buttons = buttons_width(buttons_of(claims, claim)), room = width - px(mark_room);
  const FontScope font(Face::small);
  ClaimLayout layout;
  layout.lines = sentence(claims, claim);
  layout.one_row = text_width(layout.lines) + buttons + px(8) <= room;
  if (!layout.one_row) layout.lines = in_lines(layout.lines, room);
  layout.text_height = text_height(layout.lines);
  return layout;
}

void draw_mark(ImVec2 at, float height, std::optional<bool> holds) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = at.x + px(4), y = at.y + height / 2;
  if (!holds) {
    list.AddCircle({x + px(5), y}, px(4), colour_u32(palette().text_quiet), 0, px(1.5));
  } else if (*holds) {
    const ImVec2 tick[]{{x, y}, {x + px(4), y + px(4)}, {x + px(11), y - px(5)}};
    list.AddPolyline(tick, 3, colour_u32(palette().right_mark), ImDrawFlags_None, px(2.5));
  } else {
    const ImU32 ink = colour_u32(palette().wrong_mark);
    list.AddLine({x, y - px(5)}, {x + px(10), y + px(5)}, ink, px(2.5));
    list.AddLine({x, y + px(5)}, {x + px(10), y - px(5)}, ink, px(2.5));
  }
}

}  // namespace

float claim_line_height(const LessonClaims& claims, std::size_t claim, float width) {
  const ClaimLayout layout = layout_of(claims, claim, width);
  const float frame = ImGui::GetFrameHeight();
  return layout.one_row ? std::max(layout.text_height, frame) : layout.text_height + px(2) + frame;
}

void claim_line(Session& session, LessonClaims& claims, std::size_t claim, float width) {
  const NameScope scope(fmt::format("claim/{}", claim));
  claims.measure_changed(session);
  const ClaimLayout layout = layout_of(claims, claim, width);
  const Claim& of = claims.claims().at(claim);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float frame = ImGui::GetFrameHeight(), row = layout.one_row ? frame : layout.text_height;
  const auto value = claims.value(claim);
  const std::optional<bool> holds = value ? std::optional(of.bound.holds(*value)) : std::nullopt;
  const ImVec2 text{at.x + px(mark_room), std::floor(at.y + (row - layout.text_height) / 2)};
  {
    const FontScope font(Face::small);
    draw_mark(at, layout.one_row ? frame : ImGui::GetTextLineHeight(), holds);
    ImGui::SetCursorScreenPos(text);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    value_text("measured", layout.lines);
    ImGui::PopStyleColor();
  }
  tooltip("Measured on what the screen shows, each time that it changes.");
  controls().record("state", at, {at.x + px(mark_room), at.y + row}, !holds ? "open" : *holds ? "holds" : "broken");
  const std::vector<ClaimButton> buttons = buttons_of(claims, claim);
  ImVec2 place{at.x + px(mark_room), at.y + layout.text_height + px(2)};
  if (layout.one_row) place = {at.x + width - buttons_width(buttons) + px(6), at.y};
  std::optional<ClaimShown> wanted;
  for (const ClaimButton& each : buttons) {
    ImGui::SetCursorScreenPos(place);
    const std::string help = each.leads_to == ClaimShown::mutation
                                 ? fmt::format("Changes what makes it true: {}. The claim should then not hold.",
                                               mutation_words(of.mutation))
                             : each.leads_to == ClaimShown::claim
                                 ? std::string("Puts on the screen what the claim is about.")
                                 : std::string("Puts back what was on the screen before.");
    if (button(each.name, each.label, Emphasis::plain, {.tooltip = help})) wanted = each.leads_to;
    place.x += button_width(each.label) + px(6);
  }
  ImGui::SetCursorScreenPos(at);
  if (wanted) claims.show(session, claim, *wanted);
}

}  // namespace ps::gui
