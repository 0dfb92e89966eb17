#include "gui/panels/lesson/step_controls.h"

#include <algorithm>
#include <vector>

#include "gui/panels/options/row_results.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// Adds the options of the "key=value" lines that `others` lacks, each once.
void add_options(const std::vector<std::string>& lines, const std::vector<std::string>& others,
                 std::vector<const Option*>& options) {
  for (const std::string& line : lines) {
    if (std::find(others.begin(), others.end(), line) != others.end()) continue;
    const Option* option = find_option(line.substr(0, line.find('=')));
    if (option && std::find(options.begin(), options.end(), option) == options.end()) options.push_back(option);
  }
}

/// What a step is about: the options that it sets differently in A and B, or else all that it sets.
std::vector<const Option*> options_of(const LessonState& state) {
  std::vector<const Option*> options;
  add_options(state.set_a, state.set_b, options);
  add_options(state.set_b, state.set_a, options);
  if (options.empty()) add_options(state.set_a, {}, options);
  return options;
}

void rows(Session& session, Side side, const std::vector<const Option*>& options) {
  const NameScope scope(side == Side::a ? "a" : "b");
  const Side other = other_side(side);
  for (const Option* option : options) {
    Settings settings = session.settings(side);
    OptionRowContext context;
    context.side = side;
    context.other = &session.settings(other);
    const OptionRowResult result = option_row(*option, settings, session.traits(), context);
    take_row_result(session, side, *option, settings, result);
  }
}

}  // namespace

void step_controls(Session& session, const LessonStep& step) {
  const std::vector<const Option*> options = options_of(step.state);
  if (options.empty()) return;
  for (const Side side : both_sides) {
    ImGui::Spacing();
    {
      const FontScope font(Face::bold);
      ImGui::PushStyleColor(ImGuiCol_Text, side == Side::a ? palette().a_text : palette().b_text);
      ImGui::TextUnformatted(side == Side::a ? "Options of A" : "Options of B");
      ImGui::PopStyleColor();
    }
    rows(session, side, options);
  }
}

}  // namespace ps::gui
