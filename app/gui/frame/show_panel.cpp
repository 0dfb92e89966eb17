#include "gui/frame/show_panel.h"

#include <imgui.h>

#include <algorithm>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

/// The share of the height that the drawer opens with: large type needs more of a low window.
double opened_share() {
  constexpr double share = 0.45, least = 250;  // least: of the whole window, pixels at scale 1
  return std::max(share, static_cast<double>(px(least) / ImGui::GetIO().DisplaySize.y));
}
}  // namespace

bool bottom_is_open(const Document& document) {
  return document.layout.filled == region_names::bottom || document.layout.bottom > 0;
}

void open_bottom(Session& session, bool open) {
  if (open == bottom_is_open(session.document())) return;
  session.navigate([&](Document& document) {
    if (document.layout.filled == region_names::bottom) document.layout.filled.clear();
    document.layout.bottom = open ? opened_share() : 0;
  });
}

void set_mode(Session& session, ScreenMode mode) {
  session.navigate([&](Document& document) {
    document.mode = mode;
    document.layout.panels = true;
    document.layout.filled.clear();
  });
}

bool leave_presenter(Session& session) {
  const Document& document = session.document();
  if (document.mode != ScreenMode::presenter) return false;
  set_mode(session, document.lesson.empty() ? ScreenMode::explore : ScreenMode::lesson);
  return true;
}

void show_panel(Session& session, std::string_view name) {
  if (session.document().mode == ScreenMode::lesson) {
    session.navigate([&](Document& document) {
      document.layout.panels = true;
      document.layout.stage = name;
      if (document.layout.filled != region_names::bottom) document.layout.filled.clear();
    });
    return;
  }
  if (session.document().layout.filled != region_names::bottom) fill_window(session, {});
  if (session.document().mode != ScreenMode::study) open_bottom(session, true);
  session.navigate([&](Document& document) {
    document.layout.panels = true;
    document.layout.bottom_tab = name;
  });
}

void make_room_for(Session& session, const Panel& tool) {
  if (tool.facts.use == PanelUse::pixel) {
    if (session.document().mode == ScreenMode::study) set_mode(session, ScreenMode::explore);
  } else if (tool.facts.group != ToolGroup::pixels) {
    if (session.document().mode == ScreenMode::explore) set_mode(session, ScreenMode::study);
  }
}

void fill_window(Session& session, std::string_view region) {
  session.navigate([&](Document& document) { document.layout.filled = region; });
}

}  // namespace ps::gui
