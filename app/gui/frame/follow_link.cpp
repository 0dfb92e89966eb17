#include "gui/frame/follow_link.h"

#include "gui/frame/show_panel.h"
#include "gui/widgets/flash.h"
#include "options/option.h"

namespace ps::gui {
namespace {

/// In a lesson the step's text has the control, else the options panel.
void show_option(Session& session, PanelStates& my, const std::string& key, const std::function<void()>& show_options) {
  if (session.document().mode == ScreenMode::lesson) {
    my.lessons.shown_option = key;
    return flash({"lesson/a/" + key, "lesson/b/" + key});
  }
  const Option* option = find_option(key);
  if (!option) return;
  point_at_option(my.options, *option);
  show_options();
}

void show_story(Session& session, std::string_view tab) {
  const bool lesson = session.document().mode == ScreenMode::lesson;
  session.navigate([&](Document& document) {
    if (lesson)
      document.layout.stage.clear();
    else
      document.mode = ScreenMode::explore;
    document.layout.story_open = true;
    document.layout.panels = true;
    document.layout.right_tab = tab;
  });
  flash({tab == story_names::parting ? "pixel/side/parting" : "pixel/side/a"});
}

void show_linked_panel(Session& session, PanelStates& my, const std::string& name,
                       const std::function<void()>& show_options) {
  if (name == options_panel_name) return show_options();
  if (name == story_names::one || name == story_names::parting) return show_story(session, name);
  show_tool(session, my.lessons.column, name);
  flash({session.document().mode == ScreenMode::lesson ? "stage" : "bottom/" + name});
}

}  // namespace

void follow_link(Session& session, PanelStates& my, const LinkTarget& target,
                 const std::function<void()>& show_options) {
  switch (target.link.kind) {
  case LinkKind::none:
    return flash({target.control});
  case LinkKind::option:
  case LinkKind::control:
    return show_option(session, my, target.link.target, show_options);
  case LinkKind::panel:
    return show_linked_panel(session, my, target.link.target, show_options);
  case LinkKind::step:
    return go_to_step(session, session.document().lesson, target.link.step);
  case LinkKind::lesson:
    return go_to_step(session, target.link.target, target.link.step);
  case LinkKind::term:
    return open_glossary(my.lessons.glossary, target.link.target);
  }
}

}  // namespace ps::gui
