#include "gui/app/pin_view.h"

#include <fmt/format.h>

#include "gui/widgets/draw.h"
#include "inspect/number_text.h"
#include "options/scene_settings.h"

namespace ps::gui {
namespace {

constexpr double indent_step = 12;
constexpr std::size_t most_steps = 60;  // listed at once

/// "0.4 → 0.3", or one number where both are equal.
std::string both_text(const std::string& before, const std::string& after) {
  if (before == after) return after;
  return fmt::format("{} → {}", before.empty() ? "none" : before, after.empty() ? "none" : after);
}

void indent(int depth) {
  if (depth > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(indent_step) * static_cast<float>(depth));
}

void ledger_line(const LedgerChange& line, const std::string& name) {
  indent(line.level);
  ImGui::PushStyleColor(ImGuiCol_Text, line.changed() ? palette().text : palette().text_quiet);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(line.term.c_str());
  std::string numbers;
  if (!line.before || !line.after)
    numbers = (line.before ? "gone, was " : "new, ") + vector_text(line.before ? *line.before : *line.after);
  for (int channel = 0; line.before && line.after && channel < 3; ++channel) {
    const std::string before = ps::number_text((*line.before)[channel]),
                      after = ps::number_text((*line.after)[channel]);
    static constexpr std::array<const char*, 3> names{"red", "green", "blue"};
    if (before == after && line.changed()) continue;
    numbers += fmt::format("{}{} {}", numbers.empty() ? "" : "   ", names.at(static_cast<std::size_t>(channel)),
                           both_text(before, after));
  }
  if (line.changed()) {
    const FontScope font(Face::mono);
    indent(line.level + 1);
    value_text(name, numbers.empty() ? "the same to four digits" : numbers);
  }
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

bool step_row(const StepChange& step, const std::string& name, bool only_changes) {
  indent(step.depth);
  const std::string_view mark = step.before < 0 ? "new: " : step.after < 0 ? "gone: " : "";
  const std::string text = fmt::format("{}{}", mark, step.text);
  ImGui::PushID(name.c_str());
  const bool clicked = ImGui::Selectable(text.c_str());
  controls().record(name, text);
  tooltip(text);
  ImGui::PopID();
  if (step.before < 0 || step.after < 0) return clicked;
  for (const FieldChange& field : step.fields) {
    if (!field.changed && only_changes) continue;
    indent(step.depth + 1);
    ImGui::PushStyleColor(ImGuiCol_Text, field.changed ? palette().text : palette().text_quiet);
    ImGui::PushTextWrapPos(0);
    ImGui::TextWrapped("%s: %s", field.name.c_str(), both_text(field.before, field.after).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    tooltip(both_text(field.exact_before, field.exact_after));
  }
  return clicked;
}

}  // namespace

void pin_button(Session& session, PinState& state) {
  if (state.any()) {
    if (!button_on_off("pin", "Pinned", true, {.tooltip = "Lets the pixel go."})) return;
    state.pinned = {};
    state.compared = {};
    return;
  }
  if (!button_on_off("pin", "Pin", false,
                     {.tooltip = "Keeps the numbers of this pixel. Change an option then, and see old → new."}))
    return;
  for (const Side side : both_sides) {
    state.pinned[index_of(side)] = session.story(side);
    state.settings[index_of(side)] = session.settings(side);
  }
}

int pin_view(Session& session, PinState& state, Side side, const std::shared_ptr<const PixelStory>& story) {
  const std::size_t index = index_of(side);
  const auto& pinned = state.pinned[index];
  if (!pinned || !story) return -1;
  const NameScope scope("pin");
  if (pinned->pixel != story->pixel) {
    ImGui::TextWrapped("Pixel (%d, %d) is pinned; this is another one.", pinned->pixel.x, pinned->pixel.y);
    ImGui::SameLine();
    if (button("back", "Go there", Emphasis::quiet)) session.set_pixel(pinned->pixel);
    return -1;
  }
  if (state.compared[index] != story) {
    state.compared[index] = story;
    state.changes[index] = story_changes(*pinned, *story, session.scene());
  }
  const StoryChanges& changes = state.changes[index];
  const std::string note = changes.changed_steps == 0 ? "nothing" : fmt::format("{} events", changes.changed_steps);
  if (!section("changes", "Changed since the pin", state.open[index], note)) return -1;
  std::string options;
  for (const std::string& one : settings_difference(state.settings[index], session.settings(side)))
    options += (options.empty() ? "" : ", ") + one;
  ImGui::PushTextWrapPos(0);
  value_text("options", options.empty() ? "No option differs from then." : options);
  const auto& old = changes.display_before;
  const auto& now = changes.display_after;
  value_text("display", both_text(fmt::format("{} {} {}", old[0], old[1], old[2]),
                                  fmt::format("{} {} {}", now[0], now[1], now[2])));
  ImGui::PopTextWrapPos();
  toggle("only", "Only what changed", state.only_changes);
  int clicked = -1, row = 0;
  for (const LedgerChange& line : changes.ledger)
    if (line.changed() || !state.only_changes) ledger_line(line, fmt::format("ledger/{}", row++));
  ImGui::Spacing();
  std::size_t listed = 0, left_out = 0;
  for (const StepChange& step : changes.steps) {
    if (!step.changed && state.only_changes) continue;
    if (listed == most_steps) {
      ++left_out;
      continue;
    }
    if (step_row(step, fmt::format("step/{}", listed++), state.only_changes)) clicked = step.after;
  }
  if (left_out > 0) ImGui::TextDisabled("and %zu more events", left_out);
  ImGui::Spacing();
  return clicked;
}

}  // namespace ps::gui
