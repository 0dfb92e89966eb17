#include "gui/frame/window_actions.h"

#include "base/spelling.h"
#include "document/command_line.h"
#include "document/permalink.h"
#include "gui/frame/file_questions.h"
#include "gui/frame/show_panel.h"

namespace ps::gui {
namespace {

/// Actions of the mouse in the pictures and elsewhere, for the help sheet.
void add_gestures(Actions& actions) {
  for (const auto& [hand, label] : {
           std::pair{"Click", "Inspect a pixel"},
           std::pair{"Wheel", "Zoom in and out"},
           std::pair{"Drag", "Move the picture, a light or an object"},
           std::pair{"Shift+drag", "Render a rectangle alone (Esc: all)"},
           std::pair{"Alt+drag", "Move the camera around the scene"},
           std::pair{"Ctrl+drag", "Look around"},
           std::pair{"Right drag", "Look around; the keys of flying move"},
           std::pair{"Esc in a drag", "Takes back what the drag has changed"},
           std::pair{"Middle drag", "Move the picture"},
           std::pair{"Double-click", "On a heading: fill the window"},
           std::pair{"Right-click", "On an option: copy, reset, send to B"},
       })
    actions.add_gesture({hand, label, "Mouse"});
  actions.add_gesture({{}, "Flying: forward, left, back, right, down, up", "Camera", std::string(fly_keys)});
}

void add_mode_actions(Actions& actions, Session& session) {
  const auto name = [](ScreenMode mode) { return "mode-" + std::string(mode_key(mode)); };
  const auto add = [&](ScreenMode mode, const char* label, const char* key) {
    actions.add({.name = name(mode),
                 .label = label,
                 .group = "Window",
                 .keys = key,
                 .run = [&session, mode] { set_mode(session, mode); },
                 .enabled = [&session] { return session.has_scene(); },
                 .checked = [&session, mode] { return session.document().mode == mode; }});
  };
  add(ScreenMode::lesson, "Lesson: the text beside the pictures", "F2");
  add(ScreenMode::explore, "Explore: all options and tools", "F3");
  add(ScreenMode::study, "Study: one long tool beside small pictures", "F4");
  actions.add({.name = name(ScreenMode::presenter),
               .label = "Presenter: pictures alone, the lesson's text as a caption",
               .group = "Window",
               .keys = "F5",
               .run =
                   [&session] {
                     if (!leave_presenter(session)) set_mode(session, ScreenMode::presenter);
                   },
               .enabled = [&session] { return session.has_scene(); },
               .checked = [&session] { return session.document().mode == ScreenMode::presenter; }});
}

void copy_command(const PanelHost& host, const std::string& command) {
  host.copy(command, "On the clipboard: " + shown_start(command));
}

}  // namespace

void add_window_actions(Actions& actions, Session& session, const PicturesState& pictures, const PanelHost& host) {
  const auto open_scene = [&session] { return session.has_scene(); };
  actions.add(
      {.name = "open", .label = "Open a scene file...", .group = "Scene", .keys = "Ctrl+O", .run = [&host, &session] {
         host.ask_file(scene_question(session));
       }});
  actions.add({.name = "reload",
               .label = "Reload the scene",
               .group = "Scene",
               .keys = "Ctrl+R",
               .run = [&session] { session.reload(); },
               .enabled = open_scene});
  actions.add({.name = "save-picture",
               .label = "Save the pictures...",
               .group = "Scene",
               .keys = "P",
               .run = [&] { host.ask_file(picture_question(session, pictures)); },
               .enabled = open_scene});
  actions.add({.name = "save-scene",
               .label = "Save the scene with its changes...",
               .group = "Scene",
               .keys = "Ctrl+S",
               .run = [&] { host.ask_file(save_scene_question(session)); },
               .enabled = open_scene});
  actions.add({.name = "save-story",
               .label = "Save the pixel's story...",
               .group = "Scene",
               .run = [&] { host.ask_file(save_story_question(session)); },
               .enabled = [&session] { return session.story(inspected_side(session)) != nullptr; }});
  actions.add({.name = "picture-b",
               .label = "Compare with a picture file...",
               .group = "Scene",
               .run = [&] { host.ask_file(compare_question(session)); },
               .enabled = open_scene});
  actions.add({.name = "drop-picture-b",
               .label = "Render B again instead of the file",
               .group = "Scene",
               .run = [&session] { session.close_picture_b(); },
               .enabled = [&session] { return session.picture_b() != nullptr; }});
  actions.add({.name = "copy-permalink",
               .label = "Copy permalink",
               .group = "Scene",
               .keys = "C",
               .run =
                   [&] {
                     host.copy(session.permalink(),
                               "The permalink is on the clipboard. 'pixelscope-cli render --permalink TEXT --out "
                               "FILE.png' renders the picture; 'pixelscope --permalink TEXT' opens the window.");
                   },
               .enabled = open_scene});
  actions.add({.name = "copy-command",
               .label = "Copy the command that renders this picture",
               .group = "Scene",
               .keys = "Shift+C",
               .run = [&] { copy_command(host, linked_command(session.document(), LinkedCommand::render)); },
               .enabled = open_scene});
  actions.add({.name = "copy-inspect-command",
               .label = "Copy the command that prints this pixel's story",
               .group = "Scene",
               .run = [&] { copy_command(host, linked_command(session.document(), LinkedCommand::inspect)); },
               .enabled = [&session] { return session.has_scene() && session.document().pixel.x >= 0; }});
  actions.add({.name = "copy-window-command",
               .label = "Copy the command that opens this screen",
               .group = "Scene",
               .run = [&] { copy_command(host, window_command(session.document())); },
               .enabled = open_scene});
  actions.add({.name = "save-screen",
               .label = "Save the screen as a file...",
               .group = "Scene",
               .keys = "Ctrl+Shift+S",
               .run = [&] { host.ask_file(save_screen_question(session)); },
               .enabled = open_scene});
  actions.add({.name = "undo",
               .label = "Undo",
               .group = "Edit",
               .keys = "Ctrl+Z",
               .kind = ActionKind::repeat,
               .run = [&session] { session.undo(); },
               .enabled = [&session] { return session.can_undo(); }});
  actions.add({.name = "redo",
               .label = "Redo",
               .group = "Edit",
               .keys = "Ctrl+Shift+Z Ctrl+Y",
               .kind = ActionKind::repeat,
               .run = [&session] { session.redo(); },
               .enabled = [&session] { return session.can_redo(); }});
  add_mode_actions(actions, session);
  add_gestures(actions);
}

}  // namespace ps::gui
