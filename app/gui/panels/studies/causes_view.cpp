#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/panels/studies/why_tab.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr double cause_width = 260, share_width = 66;  // pixels at scale 1

/// An option, its values in A and B, and a bar of its share; shares below 0 reach to the left.
void cause_row(const CauseShare& cause, double total) {
  const Option* option = find_option(cause.option);
  const std::string label = option ? std::string(option->label) : cause.option;
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight() + px(4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({room, height});
  controls().record("cause/" + cause.option, full_number(cause.share));
  tooltip(
      cause.note.empty()
          ? fmt::format("{}: {} in A, {} in B. Set alone it changes A by {}; without it a difference of {} is left.",
                        label, cause.from, cause.to, short_number(cause.alone), short_number(cause.without))
          : fmt::format("{}: {} in A, {} in B. {}", label, cause.from, cause.to, cause.note));
  const float names = std::min(px(cause_width), room * 0.5f), digits = px(share_width);
  draw_text(at, {at.x + names, at.y + height}, fmt::format("{}: {} → {}", label, cause.from, cause.to), palette().text,
            0);
  if (!cause.note.empty()) {
    draw_text({at.x + names + px(8), at.y}, {at.x + room, at.y + height}, cause.note, palette().text_quiet, 0);
    return;
  }
  const double share = total > 0 ? cause.share / total : 0;
  {
    const FontScope mono(Face::mono);
    draw_text({at.x + names, at.y}, {at.x + names + digits, at.y + height}, fmt::format("{:.1f} %", 100 * share),
              palette().text, 1);
  }
  auto& list = *ImGui::GetWindowDrawList();
  const float left = at.x + names + digits + px(10), right = at.x + room - px(4);
  const float zero = left + (right - left) * 0.08f, unit = right - zero;
  const float end = zero + unit * static_cast<float>(std::clamp(share, -0.08, 1.0));
  list.AddRectFilled({std::min(zero, end), at.y + px(4)}, {std::max(zero, end), at.y + height - px(4)},
                     colour_u32(palette().text_quiet));
  list.AddLine({zero, at.y}, {zero, at.y + height}, colour_u32(palette().line_strong), px(1));
}

}  // namespace

void causes_view(const Session& session, const WhyTabState& state) {
  if (!state.difference) {
    const StudyStatus status = state.causes.status();
    if (state.causes.running())
      return quiet_text(status.total > 0 ? status_text(status, "pictures") : "Rendering pictures between A and B.");
    if (state.causes.state() == StudyState::failed) return quiet_text("Failed: " + state.causes.message());
    if (session.settings(Side::a) == session.settings(Side::b))
      return quiet_text("There is no difference to explain. Change an option in one of the pictures first.");
    return quiet_text("A and B may differ in several options. Which of them causes how much of the difference? Each "
                      "option's share is its effect, averaged over all orders of switching (Shapley value).");
  }
  const DifferenceByCause& found = *state.difference;
  const bool old = !(session.settings(Side::a) == state.compared[0] && session.settings(Side::b) == state.compared[1]);
  quiet_text(fmt::format("{} between A and B: {}{}{}", found.metric, short_number(found.total),
                         found.every_order ? "" : "; shares are means over random orders",
                         old ? ". The options have changed since." : ""));
  for (const CauseShare& cause : found.causes) cause_row(cause, found.total);
  if (found.causes.empty()) quiet_text("No option differs.");
}

}  // namespace ps::gui
