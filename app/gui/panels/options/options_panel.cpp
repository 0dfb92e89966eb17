#include "gui/panels/options/options_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "gui/base/region_names.h"
#include "gui/panels/options/light_actions.h"
#include "gui/panels/options/lights_panel.h"
#include "gui/panels/options/row_results.h"
#include "gui/session/scene_contents.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/option_pair.h"
#include "gui/widgets/shorten.h"
#include "options/option_search.h"

namespace ps::gui {
namespace {

/// A picture file in B's place has no options.
bool only_a(const Session& session) { return session.picture_b() != nullptr; }

bool differs(const Option& option, const Session& session) {
  return !only_a(session) && option.get(session.settings(Side::a)) != option.get(session.settings(Side::b));
}

/// Groups that show most of what changes a picture are open at the first start.
bool open_at_first(std::string_view group) { return group == option_table().front().group || group == "Shading"; }

/// Whether a script looks for something in the option's row, which is out of sight while its group is closed.
bool wanted_by_script(const Option* option) {
  const std::string_view wanted = controls().revealing();
  for (const char* side : {"a/", "b/"}) {
    const std::string row = full_name(side + std::string(option->key));
    if (wanted == row || wanted.starts_with(row + "/")) return true;
  }
  return false;
}

void pick(Session& session, Side side) {
  session.navigate([&](Document& document) { document.picked = side; });
}

/// The heads of the two columns: each picture's letter and renderer. A click picks the picture, as one in it does.
void column_heads(Session& session) {
  const Side picked = session.document().picked;
  const Palette& p = palette();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const OptionColumns columns = option_columns(ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize);
  const float height = ImGui::GetFrameHeight() + px(4);
  const NameScope scope("side");
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const Side side : both_sides) {
    const bool is_picked = side == picked;
    ImGui::SetCursorScreenPos({at.x + (side == Side::a ? columns.a : columns.b), at.y});
    const std::string letter(1, letter_of(side));
    if (hit_area(side == Side::a ? "a" : "b", {columns.width, height}, {})) pick(session, side);
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    if (is_picked || ImGui::IsItemHovered())
      draw.AddRectFilled(min, max, colour_u32(is_picked ? p.field : p.field_hover), ImGui::GetStyle().FrameRounding);
    draw.AddRectFilled({min.x, max.y - px(is_picked ? 4 : 2)}, max, colour_u32(side == Side::a ? p.a : p.b));
    draw_text({min.x + px(8), min.y}, {max.x, max.y - px(3)}, letter, p.text, 0, Face::bold);
    const FontScope small(Face::small);
    const float room = max.x - px(2) - min.x - px(26);
    const bool file = side == Side::b && only_a(session);
    const std::string renderer = file ? "file" : whole_words(renderer_label(session.settings(side).renderer), room);
    if (text_width(renderer) <= room)
      draw_text({min.x + px(26), min.y}, {max.x - px(2), max.y - px(3)}, renderer, p.text, 0);
    controls().record(side == Side::a ? "a" : "b", is_picked ? "on" : "off");
    tooltip(is_picked ? "The picked picture: its story is shown, and commands act on it."
                      : fmt::format("Picks {}, as a click in the picture does.", letter));
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({columns.b + columns.width, height});
}

/// Commands on all options at once.
void commands(Session& session) {
  const Side picked = session.document().picked, other = other_side(picked);
  const char here = letter_of(picked), there = letter_of(other);
  if (button("more", "…", Emphasis::quiet, {.tooltip = "Copy, swap or reset all options."})) ImGui::OpenPopup("##more");
  if (!ImGui::BeginPopup("##more")) return;
  const bool equal = session.settings(Side::a) == session.settings(Side::b);
  const std::string_view same = only_a(session) ? "B is a picture file."
                                : equal         ? "A and B have the same options."
                                                : "";
  if (menu_item("copy-to-other", fmt::format("Copy all options of {} to {}", here, there), {}, false, same))
    session.set_settings(other, session.settings(picked), fmt::format("copy options of {} to {}", here, there));
  if (menu_item("swap", "Swap the options of A and B", {}, false, same))
    session.edit("swap A and B", [](Document& document) { std::swap(document.a.settings, document.b.settings); });
  // Which renderer a side uses is what it is for; resetting the rest keeps the comparison.
  Settings defaults;
  defaults.renderer = session.settings(picked).renderer;
  if (menu_item("reset-all", fmt::format("Reset all options of {} but the renderer", here), {}, false,
                defaults == session.settings(picked) ? "All options have their defaults." : ""))
    session.set_settings(picked, defaults, fmt::format("reset options of {}", here));
  ImGui::EndPopup();
}

/// In place of B's options.
void file_note(Session& session) {
  const auto file = session.picture_b();
  if (!file) return;
  const std::string name = std::filesystem::path(file->path).filename().string();
  value_paragraph("b-is-file", fmt::format("B is {}: a file has no options.", name), {Face::small, true});
  tooltip(file->path);
  if (button("render-b", "Render B again", Emphasis::plain, {.tooltip = "Shows the scene in B, as before the file."}))
    session.close_picture_b();
}

void header(Session& session, OptionsPanelState& state) {
  const float room = ImGui::GetContentRegionAvail().x, more = button_width("…"), between = px(4);
  const float field = room - more - between, lens = px(52);  // with the field's margins
  const std::string_view hint = text_width("Find an option") + lens <= field ? "Find an option" : "Find";
  if (search_box("search", state.search, hint, {.width = field})) state.pointed = nullptr;
  ImGui::SameLine(0, between);
  commands(session);
  const bool wide = text_width("Only differences") + px(44) <= room;
  toggle("only-differences", wide ? "Only differences" : "Differences", state.only_differences,
         {.tooltip = "Shows only options that differ between A and B."});
  file_note(session);
  column_heads(session);
  controls().record("side", std::string(1, static_cast<char>(letter_of(session.document().picked) - 'A' + 'a')));
}

void row(const PanelHost& host, OptionsPanelState& state, const Option& option) {
  Session& session = host.session;
  std::array<Settings, 2> settings{session.settings(Side::a), session.settings(Side::b)};
  OptionPairContext context;
  context.picked = inspected_side(session);
  if (only_a(session)) context.b_has_none = "B is a picture file, which has no options.";
  context.highlight = state.pointed == &option;
  const bool come = context.highlight && std::exchange(state.come_to_pointed, false);
  const auto results = option_pair(option, settings, session.traits(), context);
  if (come) ImGui::SetScrollHereY();
  for (const Side side : both_sides) {
    const OptionRowResult& result = results[index_of(side)];
    if (result.edit.finished && state.pointed == &option) state.pointed = nullptr;
    if (result.request == OptionRequest::sweep) {
      pick(session, side);
      host.send(SweepOption{&option, side});
      host.send(ShowTool{"chart"});
    }
    take_row_result(session, side, option, settings[index_of(side)], result);
  }
}

/// The rows of one group that the filters leave: first those that act somewhere.
struct GroupRows {
  std::string name;
  std::vector<const Option*> acting, resting;
  int different = 0;
};

/// The group that begins at `first`, which is moved behind it.
GroupRows group_rows(const Session& session, OptionsPanelState& state, std::size_t& first) {
  const auto table = option_table();
  GroupRows group{.name = std::string(table[first].group), .acting = {}, .resting = {}};
  for (; first < table.size() && table[first].group == group.name; ++first) {
    const Option& option = table[first];
    const bool differ = differs(option, session);
    group.different += differ ? 1 : 0;
    if (!option_matches(option, state.search) || (state.only_differences && !differ)) continue;
    // A row that differs, or that something points at, keeps its place.
    const bool keeps_place = differ || state.pointed == &option;
    const bool rests = !keeps_place && std::all_of(both_sides.begin(), both_sides.end(), [&](Side side) {
      return (side == Side::b && only_a(session)) ||
             !waking_of(option, session.settings(side), session.traits()).reason.empty();
    });
    (rests ? group.resting : group.acting).push_back(&option);
  }
  return group;
}

void draw_group(const PanelHost& host, OptionsPanelState& state, const GroupRows& group) {
  const bool filtered = !state.search.empty() || state.only_differences;
  auto& open = state.open.try_emplace(group.name, open_at_first(group.name)).first->second;
  auto& resting_open = state.open.try_emplace(group.name + "/resting", false).first->second;
  // A filter shows what it finds; which groups are open without it is not lost.
  bool filtered_open = true, resting_filtered = true;
  bool& shown_open = filtered ? filtered_open : open;
  bool& shown_resting = filtered ? resting_filtered : resting_open;
  if (state.come_to_pointed && state.pointed->group == group.name) shown_open = true;
  const bool wants_resting = std::any_of(group.resting.begin(), group.resting.end(), wanted_by_script);
  shown_resting = shown_resting || wants_resting;
  shown_open = shown_open || wants_resting || std::any_of(group.acting.begin(), group.acting.end(), wanted_by_script);
  const std::string note = group.different > 0 ? fmt::format("{} differ", group.different) : "";
  if (!section("group/" + group.name, group.name, shown_open, note)) return;
  for (const Option* option : group.acting) row(host, state, *option);
  if (group.resting.empty()) return;
  if (!filtered) {
    const FontScope small(Face::small);
    ImGui::Indent(px(16));
    const std::string label = fmt::format("Not used here ({})", group.resting.size());
    const bool rest_open = section("resting/" + group.name, label, shown_resting);
    ImGui::Unindent(px(16));
    if (!rest_open) return;
  }
  for (const Option* option : group.resting) row(host, state, *option);
}

}  // namespace

OptionsPanel::OptionsPanel(const PanelHost& host, ObjectSelection& selection)
    : Panel(host, {.name = region_names::left,
                   .place = PanelPlace::left,
                   .heading = "Options",
                   .brief = "Options",
                   .command = "Options",
                   .help = "All options of A and of B."}),
      selection_(selection) {}

void OptionsPanel::add_actions(Actions& actions) {
  add_light_actions(actions, session_, state_.selected_light);
  ActionGroup edit(actions, "Edit", [this] { return session_.has_scene(); });
  edit.add("object", "Object: place, size and material of the picked one", "", [this] {
    state_.object.open = true;
    state_.object.come = 3;
    host_.send(ShowOptions{});
    key_focus().go_to("options/object/gizmo");
  });
  edit.add("lights", "Lights: brightness, colours and size", "", [this] {
    state_.lights_open = true;
    host_.send(ShowOptions{});
    key_focus().go_to(
        fmt::format("options/light/{}/intensity", selected_light(session_.scene(), state_.selected_light)));
  });
  edit.add("object-add-sphere", "Add a sphere", "", [this] { add_object(session_, selection_.object, "sphere"); });
  edit.add("object-add-box", "Add a box", "", [this] { add_object(session_, selection_.object, "box"); });
  ActionGroup picked(actions, "Edit", [this] { return selection_.object.index(session_).has_value(); });
  picked.add("object-duplicate", "Duplicate the picked object", "",
             [this] { duplicate_object(session_, selection_.object); });
  picked.add("object-delete", "Delete the picked object", "Delete",
             [this] { remove_object(session_, selection_.object); });
}

/// Brings an option's row into sight and highlights it.
void OptionsPanel::take(const PanelMessage& message) {
  const auto* asked = std::get_if<PointAtOption>(&message);
  if (!asked) return;
  state_.pointed = asked->option;
  state_.come_to_pointed = true;
  state_.search.clear();
  state_.only_differences = false;
}

bool OptionsPanel::draw(const Context&) {
  Session& session = session_;
  OptionsPanelState& state = state_;
  if (!session.has_scene()) return false;
  const NameScope scope("options");
  header(session, state);
  ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar);  // columns keep their width
  bool any = false;
  for (std::size_t first = 0; first < option_table().size();) {
    const GroupRows group = group_rows(session, state, first);
    if (group.acting.empty() && group.resting.empty()) continue;
    any = true;
    draw_group(host_, state, group);
  }
  if (any && state.search.empty() && !state.only_differences) {
    lights_panel(session, state.selected_light, state.lights_open);
    object_panel(session, state.object, selection_.object, selection_.gizmo);
  }
  if (!any) {
    const char* nothing =
        state.only_differences && state.search.empty() ? "A and B have the same options." : "No option matches.";
    value_paragraph("nothing-found", nothing);
  }
  ImGui::EndChild();
  return false;
}

}  // namespace ps::gui
