#include "gui/shell/help_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/base/values.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/overlay.h"

namespace ps::gui {
namespace {

std::vector<std::string> groups_of(const Actions& actions) {
  std::vector<std::string> groups;
  const auto add = [&](const std::string& group) {
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  };
  for (const Gesture& gesture : actions.gestures()) add(gesture.group);
  for (const Action& action : actions.all()) add(action.group);
  return groups;
}

/// Rows under a heading.
std::size_t members_of(const Actions& actions, const std::string& group) {
  const auto of_group = [&](const auto& row) { return row.group == group; };
  return static_cast<std::size_t>(std::ranges::count_if(actions.all(), of_group) +
                                  std::ranges::count_if(actions.gestures(), of_group));
}

/// Its keys, as many of them as fit beside what it does; the first one always.
std::string keys_of(const Actions& actions, const Action& action, float room) {
  const FontScope mono(Face::mono);
  std::string text;
  for (const std::string& key : actions.key_texts(action.name)) {
    std::string more = text;
    more.append(text.empty() ? "" : "  ").append(key);
    if (!text.empty() && ImGui::CalcTextSize(more.c_str()).x > room) break;
    text = std::move(more);
  }
  return text;
}

/// The hand of a gesture, keys by place as the keyboard has them.
std::string hand_text(const Gesture& gesture) {
  return gesture.places.empty() ? gesture.hand : keyboard_layout().labels_of_places(gesture.places);
}

/// The action on the left, its keys on the right; where both do not fit side by side, what it does takes more lines.
void row(const std::string& label, const std::string& keys, float width) {
  const float line = ImGui::GetTextLineHeight();
  float keys_width = 0;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  {
    const FontScope mono(Face::mono);
    keys_width = ImGui::CalcTextSize(keys.c_str()).x;
    draw_text({at.x + width - keys_width, at.y}, {at.x + width, at.y + line}, keys, palette().text, 1);
  }
  const float room = width - keys_width - px(14);
  const std::string lines = in_lines(label, room);
  draw_lines(at, lines, palette().text_quiet);
  ImGui::Dummy({width, text_height(lines)});
}

void draw_group(const Actions& actions, const std::string& group, float width) {
  {
    const FontScope bold(Face::bold);
    ImGui::TextUnformatted(group.c_str());
  }
  for (const Action& action : actions.all()) {
    if (action.group != group) continue;
    const std::string label = action.label + (action.kind == ActionKind::hold ? " (hold)" : "");
    row(label, keys_of(actions, action, width - text_width(label) - px(14)), width);
  }
  for (const Gesture& gesture : actions.gestures())
    if (gesture.group == group) row(gesture.label, hand_text(gesture), width);
  ImGui::Dummy({0, px(8)});
}

}  // namespace

bool HelpSheet::take_key(const Chord& chord) {
  if (!open_ || chord != parse_chord("Esc")) return false;
  open_ = false;
  return true;
}

void HelpSheet::draw(const Actions& actions) {
  values().publish("help/open", open_);
  if (!open_) return;
  const NameScope names("help");
  const Overlay sheet("##help", {1260, 860}, just_opened_);
  if (overlay_title("Keys")) open_ = false;
  if (button("notation", "Scene notation", Emphasis::plain, {.tooltip = "What a scene file may say."})) {
    open_ = false;
    actions.run("scene-notation");
  }
  ImGui::BeginChild("##sheet");
  const int columns = std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().x / px(330)));
  // Groups fill the columns from the top, each column about as long as the others.
  std::size_t lines = 0;
  const auto groups = groups_of(actions);
  const std::size_t total = actions.all().size() + actions.gestures().size() + 2 * groups.size();
  const auto per_column = (total + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {px(18), 0});
  if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    for (const std::string& group : groups) {
      const std::size_t members = members_of(actions, group);
      if (lines > 0 && lines + (members + 2) / 2 > per_column && ImGui::TableGetColumnIndex() + 1 < columns) {
        ImGui::TableNextColumn();
        lines = 0;
      }
      draw_group(actions, group, ImGui::GetContentRegionAvail().x);
      lines += members + 2;
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (sheet.left()) open_ = false;
}

}  // namespace ps::gui
