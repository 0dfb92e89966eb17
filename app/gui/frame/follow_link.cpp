#include "gui/frame/follow_link.h"

#include "gui/frame/show_panel.h"
#include "gui/widgets/flash.h"
#include "options/option.h"

namespace ps::gui {
namespace {

/// Outside of a lesson, whose text has the control.
void show_option(const PanelHost& host, const std::string& key) {
  const Option* option = find_option(key);
  if (!option || host.session.document().mode == ScreenMode::lesson) return;
  host.send(PointAtOption{option});
  host.send(ShowOptions{});
}

void show_story(Session& session, std::string_view tab) {
  const bool lesson = session.document().mode == ScreenMode::lesson;
  session.navigate([&](Document& document) {
    if (lesson)
      document.layout.stage = story_names::one;
    else
      document.mode = ScreenMode::explore;
    document.layout.story_open = true;
    document.layout.panels = true;
    document.layout.right_tab = tab;
  });
  flash({tab == story_names::parting ? "pixel/side/parting" : "pixel/side/a"});
}

void show_linked_panel(const PanelHost& host, const std::string& name) {
  if (name == options_panel_name) return host.send(ShowOptions{});
  if (name == story_names::one || name == story_names::parting) return show_story(host.session, name);
  host.send(ShowTool{name, ShowTool::Room::as_there_is});
  flash({host.session.document().mode == ScreenMode::lesson ? "stage" : "bottom/" + name});
}

}  // namespace

void follow_link(const PanelHost& host, const LinkTarget& target) {
  switch (target.link.kind) {
  case LinkKind::none:
    return flash({target.control});
  case LinkKind::option:
  case LinkKind::control:
    return show_option(host, target.link.target);
  case LinkKind::panel:
    return show_linked_panel(host, target.link.target);
  case LinkKind::step:
  case LinkKind::lesson:
  case LinkKind::term:
    return;
  }
}

}  // namespace ps::gui
