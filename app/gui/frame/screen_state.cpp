#include "gui/frame/screen_state.h"

#include <array>
#include <utility>

namespace ps::gui {
namespace {

using Shown = PixelPanelState::Shown;

constexpr std::array<std::pair<Shown, const char*>, 3> tabs{
    {{Shown::one, "story"}, {Shown::both, "both"}, {Shown::parting, "parting"}}};

std::string text_of(Shown shown) {
  for (const auto& [value, text] : tabs)
    if (value == shown) return text;
  return tabs[0].second;
}

Shown shown_of(const std::string& tab) {
  for (const auto& [value, text] : tabs)
    if (text == tab) return value;
  return Shown::one;
}

void mirror_tab(Session& session, PixelPanelState& panel, ScreenMirror& mirror) {
  if (const std::string& asked = session.document().layout.right_tab; asked != mirror.right_tab) {
    mirror.right_tab = asked;
    panel.shown = shown_of(asked);
    return;
  }
  const std::string now = text_of(panel.shown);
  if (now == text_of(shown_of(mirror.right_tab))) return;
  mirror.right_tab = now;
  session.navigate([&](Document& document) { document.layout.right_tab = now; });
}

void mirror_event(Session& session, PixelPanelState& panel, ScreenMirror& mirror) {
  const Side side = inspected_side(session);
  if (session.document().event != mirror.event) {
    mirror.event = session.document().event;
    mirror.wanted = mirror.event;
  }
  StoryCursor& cursor = panel.cursors[index_of(side)];
  if (mirror.wanted) {
    const auto story = session.story(side);
    if (!story || session.inspector(side).busy()) return;
    if (*mirror.wanted < static_cast<int>(story->events.size())) {
      cursor = StoryCursor{};
      cursor.selected = *mirror.wanted;
      cursor.reveal = cursor.selected >= 0;
      cursor.page = std::max(cursor.selected, 0) / events_per_page;
      panel.followed[index_of(side)] = story;  // so that the panel does not begin anew with it
    }
    mirror.wanted.reset();
  }
  if (cursor.selected == session.document().event) return;
  mirror.event = cursor.selected;
  session.navigate([&](Document& document) { document.event = cursor.selected; });
}

}  // namespace

void mirror_screen(Session& session, PixelPanelState& panel, ScreenMirror& mirror) {
  if (!session.has_scene()) return;
  mirror_tab(session, panel, mirror);
  mirror_event(session, panel, mirror);
}

}  // namespace ps::gui
