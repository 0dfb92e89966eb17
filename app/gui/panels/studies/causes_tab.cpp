#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/panels/studies/why_tab.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr float most_of_row = 0.6f;  // for an option and its values

struct CauseWords {
  std::string label, from, to;
  std::string text() const { return fmt::format("{}: {} → {}", label, from, to); }
};

CauseWords words_of(const CauseShare& cause) {
  const Option* option = find_option(cause.option);
  if (!option) return {cause.option, cause.from, cause.to};
  return {std::string(option->label), value_label(*option, cause.from), value_label(*option, cause.to)};
}

/// An option, its values in A and B, and a bar of its share; shares below 0 reach to the left. `names`: the width of
/// the first column.
void cause_row(const CauseShare& cause, double total, float names) {
  const CauseWords words = words_of(cause);
  const std::string lines = in_lines(words.text(), names);
  const float room = ImGui::GetContentRegionAvail().x, height = text_height(lines) + px(4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({room, height});
  controls().record("cause/" + cause.option, full_number(cause.share));
  tooltip(
      cause.note.empty()
          ? fmt::format("{}: {} in A, {} in B. Set alone it changes A by {}; without it a difference of {} is left.",
                        words.label, words.from, words.to, short_number(cause.alone), short_number(cause.without))
          : fmt::format("{}: {} in A, {} in B. {}", words.label, words.from, words.to, cause.note));
  const float digits = text_width("-100.0 %", Face::mono) + px(8);
  draw_lines({at.x, at.y + px(2)}, lines, palette().text);
  if (!cause.note.empty()) {
    draw_text({at.x + names + px(8), at.y}, {at.x + room, at.y + height}, cause.note, palette().text_quiet, 0);
    return;
  }
  const double share = total > 0 ? cause.share / total : 0;
  draw_text({at.x + names, at.y}, {at.x + names + digits, at.y + height}, fmt::format("{:.1f} %", 100 * share),
            palette().text, 1, Face::mono);
  auto& list = *ImGui::GetWindowDrawList();
  const float left = at.x + names + digits + px(10), right = at.x + room - px(4);
  const float zero = left + (right - left) * 0.08f, unit = right - zero;
  const float end = zero + unit * static_cast<float>(std::clamp(share, -0.08, 1.0));
  list.AddRectFilled({std::min(zero, end), at.y + px(4)}, {std::max(zero, end), at.y + height - px(4)},
                     colour_u32(palette().text_quiet));
  list.AddLine({zero, at.y}, {zero, at.y + height}, colour_u32(palette().line_strong), px(1));
}

constexpr StudyWords causes_words{
    .name = "causes",
    .title = "Causes",
    .measure = "Find out",
    .again = "Find again",
    .help = "Renders A with options of B, in every order, and divides the difference among them.",
    .preparing = "rendering pictures between A and B",
    .unit = "pictures"};

bool equal_options(const Session& session) { return session.settings(Side::a) == session.settings(Side::b); }

}  // namespace

CausesTab::CausesTab(const PanelHost& host) : Study(host, {}, causes_words) {}

void CausesTab::measure(Session& session) {
  CauseRequest request;
  request.scene = session.scene();
  request.view = session.view();
  request.a = session.settings(Side::a);
  request.b = session.settings(Side::b);
  request.priority = WorkerPriority::background;
  compared_ = {request.a, request.b};
  start([request = std::move(request)](StudyControl& control, const Report& report) {
    return std::make_shared<const DifferenceByCause>(
        difference_by_cause(request, control, [&](const StudyStatus& status) { report(status, nullptr); }));
  });
}

std::string CausesTab::reason_against(Session& session) const {
  return equal_options(session) ? "A and B have the same options." : "";
}

std::string CausesTab::about(const Session& session) const {
  if (!found) return equal_options(session) ? "A and B have the same options." : "";
  const bool old = !(session.settings(Side::a) == compared_[0] && session.settings(Side::b) == compared_[1]);
  return fmt::format("{} between A and B: {}{}{}", found->metric, short_number(found->total),
                     found->every_order ? "" : "; shares are means over random orders",
                     old ? ". The options have changed since." : "");
}

void CausesTab::draw_result(Session& session) {
  if (!found) {
    if (work.running()) return;
    return quiet_text(
        equal_options(session)
            ? "There is no difference to explain. Change an option in one of the pictures first."
            : "A and B may differ in several options. Which of them causes how much of the difference? Each option's "
              "share is its effect, averaged over all orders of switching (Shapley value).");
  }
  float names = 0;
  for (const CauseShare& cause : found->causes) names = std::max(names, text_width(words_of(cause).text()));
  names = std::min(names, ImGui::GetContentRegionAvail().x * most_of_row);
  for (const CauseShare& cause : found->causes) cause_row(cause, found->total, names);
  if (found->causes.empty()) quiet_text("No option differs.");
}

namespace {

std::optional<std::string> share_value(const DifferenceByCause& difference, std::string_view option) {
  for (const CauseShare& cause : difference.causes)
    if (cause.option == option) return script_text(cause.share);
  return {};
}

}  // namespace

void CausesTab::offer_found(Values& out) const {
  out.offer_below("why/total", [this](std::string_view rest) {
    return found && rest.empty() ? std::optional(script_text(found->total)) : std::nullopt;
  });
  out.offer_below("why/share/",
                  [this](std::string_view option) { return found ? share_value(*found, option) : std::nullopt; });
}

}  // namespace ps::gui
