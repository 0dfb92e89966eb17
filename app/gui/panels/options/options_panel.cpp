#include "gui/panels/options/options_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gui/panels/options/lights_panel.h"
#include "gui/widgets/widgets.h"
#include "options/option_search.h"

namespace ps::gui {
namespace {

bool differs(const Option& option, const Session& session) {
  return option.get(session.settings(Side::a)) != option.get(session.settings(Side::b));
}

/// Groups that show most of what changes a picture are open at the first start.
bool open_at_first(std::string_view group) { return group == option_table().front().group || group == "Shading"; }

/// Whether a script looks for the option's control, which is out of sight while its group is closed.
bool wanted_by_script(const Option* option) { return controls().reveals(full_name(option->key)); }

void header(Session& session, OptionsPanelState& state) {
  static constexpr std::array tabs{Choice{"a", "A", "Options of the left picture."},
                                   Choice{"b", "B", "Options of the right picture."}};
  int tab = static_cast<int>(index_of(state.side));
  {
    const ImVec4 accent = state.side == Side::a ? palette().a_text : palette().b_text;
    ImGui::PushStyleColor(ImGuiCol_CheckMark, accent);
    if (tab_row("side", tabs, tab)) state.side = both_sides[static_cast<std::size_t>(tab)];
    ImGui::PopStyleColor();
  }
  if (search_box("search", state.search, "Find an option")) state.pointed = nullptr;
  toggle("only-differences", "Only differences", state.only_differences,
         {.tooltip = "Shows only options that differ between A and B.", .disabled = {}});

  const Side other = other_side(state.side);
  const char here = letter_of(state.side), there = letter_of(other);
  const bool equal = session.settings(Side::a) == session.settings(Side::b);
  const std::string same = equal ? "A and B have the same options." : "";
  const std::string copy = fmt::format("Copy to {}", there);
  if (button("copy-to-other", copy, Emphasis::plain,
             {.tooltip = "Copies all options of this picture to the other one.", .disabled = same}))
    session.set_settings(other, session.settings(state.side), fmt::format("copy options of {} to {}", here, there));
  same_line_if_room(button_width("Swap"));
  if (button("swap", "Swap", Emphasis::plain, {.tooltip = "Swaps the options of A and B.", .disabled = same}))
    session.edit("swap A and B", [](Document& document) { std::swap(document.a.settings, document.b.settings); });
  same_line_if_room(button_width("Reset all"));
  // Which renderer a side uses is what it is for; resetting the rest keeps the comparison.
  Settings defaults;
  defaults.renderer = session.settings(state.side).renderer;
  if (button("reset-all", "Reset all", Emphasis::plain,
             {.tooltip = "Sets all options of this picture but the renderer to their defaults.",
              .disabled = defaults == session.settings(state.side) ? "All options have their defaults." : ""}))
    session.set_settings(state.side, defaults, fmt::format("reset options of {}", here));
}

void row(Session& session, OptionsPanelState& state, const Option& option) {
  Settings settings = session.settings(state.side);
  const Side other = other_side(state.side);
  OptionRowContext context;
  context.side = state.side;
  context.other = &session.settings(other);
  context.highlight = state.pointed == &option;
  const bool come = context.highlight && std::exchange(state.come_to_pointed, false);
  const auto result = option_row(option, settings, session.traits(), context);
  if (come) ImGui::SetScrollHereY();
  if (result.edit.finished && state.pointed == &option) state.pointed = nullptr;
  if (result.edit.changed)
    session.set_settings(state.side, settings,
                         fmt::format("{}: {} = {}", letter_of(state.side), option.key, option_text(option, settings)),
                         fmt::format("{}/{}", letter_of(state.side), option.key));
  if (result.edit.finished) session.end_drag();
  switch (result.request) {
  case OptionRequest::none:
    break;
  case OptionRequest::sweep:
    state.sweep = &option;
    break;
  case OptionRequest::send_to_other: {
    Settings changed = session.settings(other);
    option.set(changed, option.get(session.settings(state.side)));
    session.set_settings(other, changed, fmt::format("copy {}", option.label));
    break;
  }
  case OptionRequest::only_difference: {
    Settings changed = session.settings(state.side);
    option.set(changed, option.get(session.settings(other)));
    session.set_settings(other, changed, fmt::format("differ in {} only", option.label));
    break;
  }
  }
}

}  // namespace

void point_at_option(OptionsPanelState& state, const Option& option) {
  state.pointed = &option;
  state.come_to_pointed = true;
  state.search.clear();
  state.only_differences = false;
}

void options_panel(Session& session, OptionsPanelState& state) {
  const NameScope scope("options");
  header(session, state);
  ImGui::BeginChild("rows");
  const auto table = option_table();
  bool any = false;
  for (std::size_t first = 0; first < table.size();) {
    std::size_t end = first;
    std::vector<const Option*> shown;
    int different = 0;
    for (; end < table.size() && table[end].group == table[first].group; ++end) {
      const bool differ = differs(table[end], session);
      different += differ ? 1 : 0;
      if (option_matches(table[end], state.search) && (differ || !state.only_differences)) shown.push_back(&table[end]);
    }
    const std::string group(table[first].group);
    first = end;
    if (shown.empty()) continue;
    any = true;
    auto& open = state.open.try_emplace(group, open_at_first(group)).first->second;
    // A filter shows what it finds; which groups are open without it is not lost.
    bool filtered_open = true;
    bool& shown_open = state.search.empty() && !state.only_differences ? open : filtered_open;
    if (state.come_to_pointed && state.pointed->group == group) shown_open = true;
    shown_open = shown_open || std::any_of(shown.begin(), shown.end(), wanted_by_script);
    const std::string note = different > 0 ? fmt::format("{} differ", different) : "";
    if (section("group/" + group, group, shown_open, note))
      for (const Option* option : shown) row(session, state, *option);
  }
  if (any && state.search.empty() && !state.only_differences)
    lights_panel(session, state.selected_light, state.lights_open);
  if (!any) {
    const char* nothing =
        state.only_differences && state.search.empty() ? "A and B have the same options." : "No option matches.";
    ImGui::TextWrapped("%s", nothing);
    controls().record("nothing-found", nothing);
  }
  ImGui::EndChild();
}

}  // namespace ps::gui
