#include "gui/panels/lesson/text_needs.h"

#include <fmt/format.h>

#include "gui/panels/options/row_results.h"
#include "gui/widgets/option_parts.h"

namespace ps::gui {
namespace {

constexpr double need_gap = 2;

void add_line(ControlNeed need, float width, std::vector<TextLine>& lines) {
  TextLine line;
  line.gap = px(need_gap);
  line.height = need_lines_height(need.waking, need.sides, need.prefix, width);
  line.need = std::move(need);
  lines.push_back(std::move(line));
}

}  // namespace

void lay_out_needs(const TextBlock& block, const Session& session, float width, std::vector<TextLine>& lines) {
  for (const TextSpan& span : block.spans) {
    if (span.link.kind != LinkKind::control) continue;
    const Option* option = find_option(span.link.target);
    const std::vector<Side> shown = control_sides(span.link);
    std::vector<ControlNeed> needs;
    for (const Side side : shown) {
      // A value without effect of an option that acts can be taken; its list says so.
      if (!inactive_reason(*option, session.settings(side), session.traits())) continue;
      if (Waking waking = waking_of(*option, session.settings(side), session.traits()); !waking.reason.empty())
        needs.push_back({option,
                         {side},
                         std::move(waking),
                         fmt::format("{}{}: ",
                                     shown.size() == 1 ? ""
                                     : side == Side::a ? "A "
                                                       : "B ",
                                     option->label)});
    }
    if (needs.size() == 2 && waking_text(needs[0].waking) == waking_text(needs[1].waking)) {
      needs.pop_back();
      needs.front().sides = shown;
      needs.front().prefix = fmt::format("{}: ", option->label);
    }
    if (needs.empty()) continue;
    lines.back().stays_with_next = true;
    for (ControlNeed& need : needs) add_line(std::move(need), width, lines);
  }
}

void draw_need(Session& session, const ControlNeed& need, float width) {
  const auto clicked = need_lines(*need.option, need.waking, need.sides, need.prefix, width);
  if (!clicked) return;
  OptionRowResult result;
  result.request = OptionRequest::wake;
  result.waking = need.waking;
  take_row_result(session, *clicked, *need.option, session.settings(*clicked), result);
}

}  // namespace ps::gui
