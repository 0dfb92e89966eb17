#include "gui/panels/options/history_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/input/key_hint.h"
#include "gui/panels/options/work_plot.h"
#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr double picture_width = 46, picture_height = 46;  // of one side, at scale 1

/// One step: its pictures, and what it changed. Answers whether it was clicked.
bool step_row(const History::Entry& entry, std::size_t place, std::size_t now, const Texture* picture, float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string name = fmt::format("step/{}", place);
  const bool clicked = list_row(name, {width, height}, place == now);
  controls().record(name, entry.label);
  auto& list = *ImGui::GetWindowDrawList();
  const Palette& p = palette();
  const ImVec2 end{at.x + width, at.y + height};
  const float left = at.x + px(8), room = 2 * px(picture_width) + px(2);
  if (picture && !picture->empty()) {
    const auto w = static_cast<float>(picture->width()), h = static_cast<float>(picture->height());
    const ImVec2 corner{std::round(left + (room - w) / 2), std::round((at.y + end.y - h) / 2)};
    // Steps that were taken back are pale.
    list.AddImage(picture->id(), corner, {corner.x + w, corner.y + h}, {0, 0}, {1, 1},
                  IM_COL32(255, 255, 255, place > now ? 110 : 255));
  }
  {
    const FontScope font(Face::small);
    const float text_left = left + room + px(10);
    const std::string lines = in_lines(entry.label, std::max(end.x - text_left - px(4), px(40)));
    const float top = std::max(at.y + px(2), (at.y + end.y - text_height(lines)) / 2);
    list.PushClipRect(at, end, true);
    draw_lines({text_left, std::round(top)}, lines, place > now ? p.text_quiet : p.text);
    list.PopClipRect();
  }
  tooltip(place > now ? entry.label + " (undone)" : entry.label);
  return clicked;
}

/// The row that a script looks for, which is not drawn while it is out of sight.
std::optional<std::size_t> step_wanted_by_script(std::size_t count) {
  for (std::size_t place = 0; place < count && !controls().revealing().empty(); ++place)
    if (controls().reveals(full_name(fmt::format("step/{}", place)))) return place;
  return {};
}

}  // namespace

HistoryPanel::HistoryPanel(const PanelHost& host)
    : Panel(host, {.name = "history",
                   .place = PanelPlace::left,
                   .heading = "History",
                   .brief = "History",
                   .command = "History: every step with its pictures",
                   .help = "Every step with its pictures; a click goes there."}),
      thumbnails_(host.wake) {}

void HistoryPanel::add_actions(Actions& actions) {
  const auto turn = [this] {
    open_ = !open_;
    if (open_) host_.send(SetMode{ScreenMode::explore});
  };
  ActionGroup(actions, "Edit").add_toggle("history", std::string(facts.command), "Y", turn, [this] { return open_; });
}

void HistoryPanel::offer(Values& out) {
  out.offer("history/open", [this] { return open_; });
}

bool HistoryPanel::draw(const Context&) {
  const NameScope scope("history");
  const History* history = session_.history();
  if (!history) return false;
  const auto& entries = history->entries();
  const std::size_t now = history->place();
  if (button("undo", "Undo", Emphasis::plain,
             {.tooltip = with_key("One step back", "undo"),
              .disabled = session_.can_undo() ? "" : "This is the first step."}))
    session_.undo();
  ImGui::SameLine();
  if (button("redo", "Redo", Emphasis::plain,
             {.tooltip = with_key("One step forward", "redo"),
              .disabled = session_.can_redo() ? "" : "Nothing was undone."}))
    session_.redo();
  same_line_if_room(button_width("Close"));
  if (button("close", "Close", Emphasis::plain, {.tooltip = with_key("Back to the options", "history")})) open_ = false;
  value_text("place", fmt::format("step {} of {}", now + 1, entries.size()));

  // Where the panel is low the steps come first.
  const bool plots = log_.steps().size() > 1 && ImGui::GetContentRegionAvail().y > 3 * work_plots_height();
  ImGui::BeginChild("steps", {0, plots ? -work_plots_height() : 0});
  const float height = px(picture_height) + px(10);
  const bool scroll = now != shown_place_ || entries.size() != shown_count_;
  shown_place_ = now;
  shown_count_ = entries.size();
  const auto wanted = step_wanted_by_script(entries.size());
  if (scroll || wanted) {
    const float top = static_cast<float>(wanted.value_or(now)) * (height + ImGui::GetStyle().ItemSpacing.y);
    if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + ImGui::GetWindowHeight())
      ImGui::SetScrollY(std::max(0.f, top - ImGui::GetWindowHeight() / 2));
  }
  std::set<std::uint64_t> ids;
  for (const auto& entry : entries) ids.insert(entry.id);
  std::optional<std::size_t> chosen;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries.size()), height + ImGui::GetStyle().ItemSpacing.y);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const int width_of_side = static_cast<int>(px(picture_width)), most_high = static_cast<int>(px(picture_height));
      const Texture* picture = thumbnails_.find(
          entries[place].id, width_of_side, most_high,
          [document = entries[place].document, width_of_side, most_high](Prepared& prepared, Progress& progress) {
            return thumbnail(document, width_of_side, most_high, prepared, progress);
          });
      if (step_row(entries[place], place, now, picture, height)) chosen = place;
    }
  clipper.End();
  ImGui::EndChild();
  thumbnails_.update(ids);
  if (plots)
    if (const auto step = work_plots(log_, entries[now].id))
      for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].id == *step) chosen = i;
  if (chosen) session_.go_to_entry(*chosen);
  return false;
}

}  // namespace ps::gui
