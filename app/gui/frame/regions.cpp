#include "gui/frame/regions.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "gui/frame/region.h"
#include "gui/frame/show_panel.h"
#include "gui/panels/lesson/first_look.h"
#include "gui/widgets/tab_row.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// The sizes of the regions in pixels where the document leaves them to the window. They grow with it only so far that
/// the pictures keep more than half of it.
float automatic_left(float width) { return std::clamp(width * 0.2f, std::min(px(250), width * 0.26f), px(290)); }
float automatic_right(float width) { return std::clamp(width * 0.26f, std::min(px(236), width * 0.3f), px(390)); }
/// One line: the title that opens it.
float folded_height() { return ImGui::GetFrameHeight() + px(8); }

// Below it the list of options would have no line of its own.
constexpr double least_options_height = 280;

bool divider(const char* name, SplitterAxis axis, ImVec2 at, float length, float& position, float low, float high) {
  ImGui::SetCursorScreenPos(at);
  return splitter(name, axis, length, position, low, high).changed;
}

}  // namespace

void Regions::draw(const Area& area, bool offers_first_look) {
  offers_first_look_ = offers_first_look;
  answered_ = false;
  const Layout& layout = session_.document().layout;
  const float margin = px(6);
  if (layout.filled.empty() && layout.panels) return divided(area);
  if (layout.filled.empty()) {
    pictures_panel(session_, my_.pictures, {{area.min.x + margin, area.min.y}, {area.max.x - margin, area.max.y}});
    return;
  }
  if (layout.filled == "right")
    right(area);
  else if (layout.filled == "bottom")
    below(area);
  else
    left(area);
  my_.pictures.areas = {};
  my_.pictures.notes = {};
}

void Regions::divided(const Area& area) {
  const Layout shares = session_.document().layout;
  const float width = area.width(), height = area.height();
  const float margin = px(6), grip = px(6), least = px(180), folded = folded_height();
  const float wanted_left = shares.left > 0 ? static_cast<float>(shares.left) * width : automatic_left(width);
  const float wanted_right = shares.right > 0 ? static_cast<float>(shares.right) * width : automatic_right(width);
  const float wanted_bottom = shares.bottom > 0 ? static_cast<float>(shares.bottom) * height : folded;
  auto left_end = std::round(wanted_left);
  auto right_begin = std::round(width - wanted_right);
  auto bottom = std::round(height - grip - wanted_bottom);
  const float most_left = std::max(least, width * 0.5f - grip),
              least_right = std::min(width - least, width * 0.5f + grip);
  const float most_bottom = std::max(height - grip - folded, height * 0.3f);
  left_end = std::clamp(left_end, std::min(least, most_left), most_left);
  right_begin = std::clamp(right_begin, least_right, std::max(width - least, least_right));
  bottom = std::clamp(bottom, height * 0.3f, most_bottom);

  const ImVec2 at = area.min;
  left({at, {at.x + left_end, area.max.y}});
  right({{at.x + right_begin + grip, at.y}, area.max});
  below({{at.x + left_end + grip, at.y + bottom + grip}, {at.x + right_begin, area.max.y}});
  pictures_panel(session_, my_.pictures,
                 {{at.x + left_end + grip + margin, at.y}, {at.x + right_begin - margin, at.y + bottom}});

  // Only what was dragged becomes a share of its own; the rest stays with what suits the window.
  if (divider("split/left", SplitterAxis::left_right, {at.x + left_end, at.y}, height, left_end, least, most_left))
    session_.navigate([&](Document& document) { document.layout.left = left_end / width; });
  if (divider("split/right", SplitterAxis::left_right, {at.x + right_begin, at.y}, height, right_begin, least_right,
              width - least))
    session_.navigate([&](Document& document) { document.layout.right = 1 - right_begin / width; });
  if (divider("split/bottom", SplitterAxis::up_down, {at.x + left_end + grip, at.y + bottom},
              right_begin - left_end - grip, bottom, height * 0.3f, most_bottom)) {
    const bool shut = bottom >= most_bottom - 1;
    session_.navigate([&](Document& document) { document.layout.bottom = shut ? 0 : 1 - (bottom + grip) / height; });
  }
}

/// At the first start, until it is answered or a lesson is begun by other ways. Returns what room is left.
Area Regions::first_look(const Area& area) {
  if (!offers_first_look_) return area;
  if (!session_.document().lesson.empty()) {
    answered_ = true;
    return area;
  }
  const float bottom = area.min.y + first_look_height();
  begin_region(session_, "first-look", {area.min, {area.max.x, bottom}}, "NEW HERE?");
  const FirstLookAnswer answer = first_look_offer();
  ImGui::EndChild();
  answered_ = answer != FirstLookAnswer::none;
  if (answer == FirstLookAnswer::start) go_to_step(session_, first_look_lesson, 0);
  return {{area.min.x, bottom}, area.max};
}

void Regions::panel_in(const Panel& panel, const std::string& region, const Area& area) {
  begin_region(session_, region, area, std::string(panel.heading));
  panel.draw({.filled = session_.document().layout.filled == region});
  ImGui::EndChild();
}

void Regions::left(const Area& area) {
  Area options = first_look(area);
  if (my_.lessons.open(session_)) {
    const float height = area.height(), grip = px(6);
    float divide = std::round(std::min(height * lesson_share_, height - px(least_options_height)));
    panel_in(panel("lesson"), "lesson", {area.min, {area.max.x, area.min.y + divide}});
    if (divider("split/lesson", SplitterAxis::up_down, {area.min.x, area.min.y + divide}, area.width(), divide,
                height * 0.2f, height * 0.8f))
      lesson_share_ = divide / height;
    options.min.y += divide + grip;
  }
  panel_in(panel(my_.history.open ? "history" : "left"), "left", options);
}

void Regions::right(const Area& area) { panel_in(panel("right"), "right", area); }

void Regions::below(const Area& area) {
  if (!bottom_is_open(session_.document())) {
    bool open = false;
    begin_region(session_, "bottom", area);
    section("bottom/open", "SPACE, LISTING, CHART, NEEDS and others", open);
    open_bottom(session_, open);
    ImGui::EndChild();
    return;
  }
  begin_region(session_, "bottom", area);
  std::vector<Choice> tabs;
  std::vector<std::string_view> brief;
  int tab = 0;
  const Panel& shown = panel(session_.document().layout.bottom_tab);
  for (const Panel& each : panels_) {
    if (each.place != PanelPlace::below) continue;
    if (&each == &shown) tab = static_cast<int>(tabs.size());
    tabs.push_back({each.name, each.heading, each.help});
    brief.push_back(each.brief);
  }
  tabs.push_back({"fold", "↓", "Hides the panels, so that the pictures have the whole window."});
  brief.push_back("↓");
  if (tab_row("bottom", tabs, brief, tab)) {
    const std::string chosen(tabs[static_cast<std::size_t>(tab)].key);
    if (chosen == "fold")
      open_bottom(session_, false);
    else
      session_.navigate([&](Document& document) { document.layout.bottom_tab = chosen; });
  }
  const bool filled = session_.document().layout.filled == "bottom";
  if (panel(session_.document().layout.bottom_tab).draw({.filled = filled}))
    fill_window(session_, filled ? "" : "bottom");
  ImGui::EndChild();
}

}  // namespace ps::gui
