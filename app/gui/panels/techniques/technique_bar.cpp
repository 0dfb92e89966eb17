#include "gui/panels/techniques/technique_bar.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "gui/session/compare_technique.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr int most_rows = 2;  // pictures need the height more; what finds no place is in a list
constexpr std::string_view lead = "Compare", back_label = "Back", more_label = "All options", rest_label = "Others";

float between() { return px(6); }

/// The labels of a technique's buttons: its own, or those of its choices.
std::vector<std::string_view> labels_of(const Technique& technique) {
  if (technique.choices.size() == 1) return {technique.label};
  std::vector<std::string_view> labels;
  labels.reserve(technique.choices.size());
  for (const TechniqueChoice& choice : technique.choices) labels.push_back(choice.label);
  return labels;
}

float width_of_technique(const Technique& technique) {
  float width = 0;
  for (const std::string_view label : labels_of(technique)) width += button_width(label);
  return width;
}

/// Where each technique begins, as far as they find room; the rows that they take.
struct BarPlan {
  std::vector<ImVec2> places;  ///< from the bar's upper left corner; the first techniques of the table
  int rows = 1;
};

/// `end`: of the last row is left to what follows the techniques.
BarPlan plan_bar(float width, float end) {
  const float first = text_width(lead) + px(20), row_height = ImGui::GetFrameHeight() + between();
  const float all_end = width - px(8);
  BarPlan plan;
  ImVec2 at{first, 0};
  for (const Technique& technique : technique_table()) {
    const float needed = width_of_technique(technique);
    const float limit = plan.rows == most_rows ? all_end - end : all_end;
    if (at.x > first && at.x + needed > limit) {
      if (plan.rows == most_rows) break;
      ++plan.rows;
      at = {first, at.y + row_height};
      if (plan.rows == most_rows && at.x + needed > all_end - end) break;
    }
    plan.places.push_back(at);
    at.x += needed + between();
  }
  // One row may have no room for what follows it.
  if (plan.rows < most_rows && at.x + end > all_end) ++plan.rows;
  return plan;
}

float end_width() {
  return button_width(back_label) + button_width(more_label) + button_width(rest_label) + 3 * between();
}

void technique_buttons(Session& session, const Technique& technique, const TechniqueChoice* shown) {
  const bool is_switch = technique.choices.size() == 1;
  const std::vector<std::string_view> labels = labels_of(technique);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const TechniqueChoice& choice = technique.choices[i];
    if (i > 0) ImGui::SameLine(0, 0);
    const std::string name = is_switch ? std::string(technique.key) : fmt::format("{}/{}", technique.key, choice.key);
    const bool on = &choice == shown;
    const std::string help = fmt::format("{}\n{}", technique.help,
                                         on ? "Once more: back to what was before."
                                            : fmt::format("{}.", technique_command(technique, choice)));
    if (button_on_off(name, labels[i], on, {.tooltip = help})) compare_technique(session, technique, choice);
  }
}

/// Those without a place in the bar, in a list.
void other_techniques(Session& session, std::size_t from, const TechniqueChoice* shown) {
  bool wanted = false;  // by a script
  for (const Technique& technique : technique_table().subspan(from))
    wanted |= controls().revealing().starts_with(full_name(technique.key));
  if (button("others", rest_label, Emphasis::quiet, {.tooltip = "Techniques that find no room in this width."}) ||
      wanted)
    ImGui::OpenPopup("other techniques");
  if (!ImGui::BeginPopup("other techniques")) return;
  for (const Technique& technique : technique_table().subspan(from))
    for (const TechniqueChoice& choice : technique.choices)
      if (menu_item(fmt::format("{}/{}", technique.key, choice.key), technique_command(technique, choice), {},
                    &choice == shown))
        compare_technique(session, technique, choice);
  ImGui::EndPopup();
}

}  // namespace

float technique_bar_height(float width) {
  const auto rows = static_cast<float>(plan_bar(width, end_width()).rows);
  return rows * (ImGui::GetFrameHeight() + between()) + between();
}

void technique_bar(Session& session, const Area& area) {
  const NameScope scope("techniques");
  const BarPlan plan = plan_bar(area.width(), end_width());
  const ImVec2 corner{area.min.x, area.min.y + between()};
  const TechniqueChoice* shown = nullptr;
  if (const auto found = session.shown_technique()) shown = &technique_table()[found->technique].choices[found->choice];
  draw_text({corner.x + px(8), corner.y}, {corner.x + px(200), corner.y + ImGui::GetFrameHeight()}, lead,
            palette().text_quiet, 0);
  for (std::size_t i = 0; i < plan.places.size(); ++i) {
    ImGui::SetCursorScreenPos({corner.x + plan.places[i].x, corner.y + plan.places[i].y});
    technique_buttons(session, technique_table()[i], shown);
  }
  const float last_row = static_cast<float>(plan.rows - 1) * (ImGui::GetFrameHeight() + between());
  ImGui::SetCursorScreenPos({area.max.x - px(2) - end_width(), corner.y + last_row});
  if (plan.places.size() < technique_table().size()) other_techniques(session, plan.places.size(), shown);
  ImGui::SetCursorScreenPos(
      {area.max.x - px(2) - button_width(back_label) - button_width(more_label) - 2 * between(), corner.y + last_row});
  const bool has_back = session.document().before_technique != nullptr;
  if (button("back", back_label, has_back ? Emphasis::primary : Emphasis::quiet,
             {.tooltip = "Everything as it was before the first comparison: scene, camera, A and B.",
              .disabled = has_back ? "" : "There is no comparison to go back from."}))
    leave_technique(session);
  ImGui::SameLine(0, between());
  const bool open = session.document().layout.options_open;
  if (button_on_off("more", more_label, open, {.tooltip = "Every option, for A and for B, at the left."}))
    session.navigate([&](Document& document) { document.layout.options_open = !open; });
}

}  // namespace ps::gui
