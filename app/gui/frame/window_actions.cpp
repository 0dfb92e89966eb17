#include "gui/frame/window_actions.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/enumerators.h"
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
           std::pair{"Drag the ball", "In a picture's corner: move the camera around the scene"},
           std::pair{"Alt+drag", "The same anywhere in a picture"},
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
  ActionGroup window(actions, "Window", [&session] { return session.has_scene(); });
  const auto add = [&](ScreenMode mode, const char* label, const char* key, std::function<void()> run) {
    window.add_toggle("mode-" + std::string(enumerator_key(mode)), label, key, std::move(run),
                      [&session, mode] { return session.document().mode == mode; });
  };
  const auto goes_to = [&session](ScreenMode mode) { return [&session, mode] { set_mode(session, mode); }; };
  add(ScreenMode::lesson, "Lesson: the text beside the pictures", "F2", goes_to(ScreenMode::lesson));
  add(ScreenMode::explore, "Explore: all options and tools", "F3", goes_to(ScreenMode::explore));
  add(ScreenMode::study, "Study: one long tool beside small pictures", "F4", goes_to(ScreenMode::study));
  add(ScreenMode::presenter, "Presenter: pictures alone, the lesson's text as a caption", "F5", [&session] {
    if (!leave_presenter(session)) set_mode(session, ScreenMode::presenter);
  });
}

void copy_command(const PanelHost& host, const std::string& command) {
  host.copy(command, "On the clipboard: " + shown_start(command));
}

/// A permalink, with blanks where mail has broken it, or the path of a file.
void open_from_clipboard(Session& session) {
  const char* clipboard = ImGui::GetClipboardText();
  std::string text = clipboard ? clipboard : "";
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  while (!text.empty() && blank(text.back())) text.pop_back();
  if (text.empty())
    return session.say(Message::Kind::warning, "The clipboard is empty: copy a permalink first (key C).");
  std::error_code error;
  if (std::filesystem::exists(text, error)) return session.open(text);
  const std::string shown = shown_start(text);
  std::erase_if(text, blank);
  if (text.find('=') != std::string::npos) return session.open_permalink(text);
  session.say(Message::Kind::warning,
              fmt::format("The clipboard holds '{}': neither a permalink (key C copies one) nor a file.", shown));
}

}  // namespace

void add_window_actions(Actions& actions, Session& session, const PicturesState& pictures, const PanelHost& host) {
  ActionGroup(actions, "Scene").add("open", "Open a scene file...", "Ctrl+O", [&] {
    host.ask_file(scene_question(session));
  });
  ActionGroup(actions, "Scene").add("paste-permalink", "Open the permalink on the clipboard", "Ctrl+V", [&session] {
    open_from_clipboard(session);
  });
  ActionGroup scene(actions, "Scene", [&session] { return session.has_scene(); });
  scene.add("reload", "Reload the scene", "Ctrl+R", [&session] { session.reload(); });
  scene.add("save-picture", "Save the pictures...", "P", [&] { host.ask_file(picture_question(session, pictures)); });
  scene.add("save-scene", "Save the scene with its changes...", "Ctrl+S",
            [&] { host.ask_file(save_scene_question(session)); });
  ActionGroup(actions, "Scene", [&session] {
    return session.story(inspected_side(session)) != nullptr;
  }).add("save-story", "Save the pixel's story...", "", [&] { host.ask_file(save_story_question(session)); });
  scene.add("picture-b", "Compare with a picture file...", "", [&] { host.ask_file(compare_question(session)); });
  ActionGroup(actions, "Scene", [&session] {
    return session.picture_b() != nullptr;
  }).add("drop-picture-b", "Render B again instead of the file", "", [&session] { session.close_picture_b(); });
  scene.add("copy-permalink", "Copy permalink", "C", [&] {
    host.copy(session.permalink(),
              "The permalink is on the clipboard. 'pixelscope-cli render --permalink TEXT --out FILE.png' renders the "
              "picture; 'pixelscope --permalink TEXT' opens the window.");
  });
  scene.add("copy-command", "Copy the command that renders this picture", "Shift+C",
            [&] { copy_command(host, linked_command(session.document(), LinkedCommand::render)); });
  ActionGroup(actions, "Scene", [&session] {
    return session.has_scene() && session.document().pixel.x >= 0;
  }).add("copy-inspect-command", "Copy the command that prints this pixel's story", "", [&] {
    copy_command(host, linked_command(session.document(), LinkedCommand::inspect));
  });
  scene.add("copy-window-command", "Copy the command that opens this screen", "",
            [&] { copy_command(host, window_command(session.document())); });
  scene.add("save-screen", "Save the screen as a file...", "Ctrl+Shift+S",
            [&] { host.ask_file(save_screen_question(session)); });
  scene.add("save-bundle", "Save a bundle: the screen with the scene's files...", "",
            [&] { host.ask_file(save_bundle_question(session)); });
  ActionGroup(actions, "Edit", [&session] {
    return session.can_undo();
  }).add_repeated("undo", "Undo", "Ctrl+Z", [&session] { session.undo(); });
  ActionGroup(actions, "Edit", [&session] {
    return session.can_redo();
  }).add_repeated("redo", "Redo", "Ctrl+Shift+Z Ctrl+Y", [&session] { session.redo(); });
  add_mode_actions(actions, session);
  add_gestures(actions);
}

}  // namespace ps::gui
