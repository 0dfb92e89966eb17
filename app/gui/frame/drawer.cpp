#include "gui/frame/drawer.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/frame/show_panel.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/tab_row.h"

namespace ps::gui {
namespace {

struct GroupRow {
  ToolGroup group;
  Choice tab;  ///< a group of one tool has the tool's name
};
const std::array<GroupRow, 4> groups{
    GroupRow{ToolGroup::pixel, {"pixel", "Pixel", "What happens at the picked pixel."}},
    GroupRow{ToolGroup::pixels, {"pixels", "Pixels", "The worst pixels, watched ones, and the levels of a rectangle."}},
    GroupRow{ToolGroup::measure, {"measure", "Measure", "Time, error, and what makes A and B differ."}},
    GroupRow{ToolGroup::stability, {"stability", "Stability", "Where methods fail: naive beside robust."}},
};

std::size_t place_of(ToolGroup group) { return static_cast<std::size_t>(group); }

std::vector<const Panel*> tools_of(const PanelList& panels, ToolGroup group) {
  std::vector<const Panel*> tools;
  for (const Panel& panel : panels)
    if (panel.facts.place == PanelPlace::below && panel.facts.group == group) tools.push_back(&panel);
  return tools;
}

/// The tool in sight below the pictures; nullptr while the drawer is folded.
const Panel* open_tool(const Session& session, const PanelList& panels) {
  const Document& document = session.document();
  const bool stage = document.mode == ScreenMode::lesson && document.layout.filled.empty();
  if (!stage && document.mode != ScreenMode::study && !bottom_is_open(document)) return nullptr;
  const std::string& name = stage ? document.layout.stage : document.layout.bottom_tab;
  const auto found = std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) {
    return panel.facts.place == PanelPlace::below && panel.facts.name == name;
  });
  return found == panels.end() ? nullptr : &found->get();
}

/// The tool that a group opens with.
std::string_view first_tool(const PanelList& panels, const DrawerState& state, ToolGroup group) {
  const std::string_view last = state.last[place_of(group)];
  return last.empty() ? tools_of(panels, group).front()->facts.name : last;
}

/// The tools of a group, in the line of the groups where there is room.
void tool_tabs(Session& session, const std::vector<const Panel*>& tools, const Panel& open) {
  std::vector<Choice> tabs;
  std::vector<std::string_view> brief;
  int index = 0;
  float width = 0;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (tools[i] == &open) index = static_cast<int>(i);
    const PanelFacts& facts = tools[i]->facts;
    tabs.push_back({facts.name, facts.heading, facts.help});
    brief.push_back(facts.brief);
    width += text_width(facts.heading) + px(22);
  }
  same_line_if_room(width + button_width("↓") + px(16), px(24));
  if (tab_row(region_names::bottom, tabs, brief, index)) show_panel(session, tabs[static_cast<std::size_t>(index)].key);
}

/// A script looks for the tab of a tool whose group is not open.
void reveal_for_script(Session& session, const PanelList& panels, const Panel* open) {
  for (const Panel& panel : panels)
    if (panel.facts.place == PanelPlace::below && &panel != open && (!open || panel.facts.group != open->facts.group) &&
        controls().reveals(full_name("bottom/" + std::string(panel.facts.name))) &&
        tools_of(panels, panel.facts.group).size() > 1)
      show_panel(session, panel.facts.name);
}

}  // namespace

void drawer_tabs(Session& session, const PanelList& panels, DrawerState& state) {
  const Panel* open = open_tool(session, panels);
  reveal_for_script(session, panels, open);
  std::vector<Choice> tabs;
  int index = -1;
  for (const GroupRow& row : groups) {
    if (open && open->facts.group == row.group) index = static_cast<int>(tabs.size());
    tabs.push_back(row.tab);
  }
  if (open) state.last[place_of(open->facts.group)] = open->facts.name;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  if (tab_row(region_names::bottom, tabs, {}, index, open ? button_width("↓") : 0))
    show_panel(session, first_tool(panels, state, groups[static_cast<std::size_t>(index)].group));
  if (!open) return;
  if (const auto tools = tools_of(panels, open->facts.group); tools.size() > 1) tool_tabs(session, tools, *open);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({right - button_width("↓"), at.y});
  if (button("bottom/fold", "↓", Emphasis::quiet,
             {.tooltip = "Folds the drawer, so that the pictures have its place."}))
    open_bottom(session, false);
  ImGui::SetCursorScreenPos(below);
}

void add_drawer_actions(Actions& actions, Session& session, const PanelList& panels, DrawerState& state) {
  for (const GroupRow& row : groups)
    actions.add({.name = "tools-" + std::string(row.tab.key),
                 .label = fmt::format("Tools: {} (again: the next one)", row.tab.label),
                 .group = "Study",
                 .keys = fmt::format("Ctrl+{}", place_of(row.group) + 1),
                 .run =
                     [&session, &panels, &state, group = row.group] {
                       const auto tools = tools_of(panels, group);
                       const Panel* open = open_tool(session, panels);
                       const auto at = std::find(tools.begin(), tools.end(), open);
                       const std::string_view next =
                           at == tools.end()
                               ? first_tool(panels, state, group)
                               : tools[static_cast<std::size_t>(at - tools.begin() + 1) % tools.size()]->facts.name;
                       make_room_for(session, find_panel(panels, next));
                       show_panel(session, next);
                     },
                 .enabled = [&session] { return session.has_scene(); }});
}

void offer_drawer_values(Values& out, Session& session, const PanelList& panels) {
  for (const Panel& panel : panels)
    if (panel.facts.place == PanelPlace::below)
      out.offer("bottom/" + std::string(panel.facts.name),
                [&session, &panels, &panel] { return open_tool(session, panels) == &panel; });
}

}  // namespace ps::gui
