// Everything that can be done by a key, a menu or the palette, in one table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/command_line.h"
#include "gui/frame/app.h"
#include "gui/input/actions.h"
#include "gui/session/camera_moves.h"
#include "render/channel_picture.h"

namespace ps::gui {
namespace {

constexpr double turn_step = 5 * std::numbers::pi / 180;  // radians for one press
constexpr int far_nudge = 10;                             // pixels, with Shift
constexpr double light_share = 0.05;                      // of the scene's reach, for one press

/// What the mouse does in the pictures and elsewhere, for the help sheet.
void add_gestures(Actions& actions) {
  for (const auto& [hand, label] : {
           std::pair{"Click", "Inspect a pixel"},
           std::pair{"Wheel", "Zoom in and out"},
           std::pair{"Drag", "Move the picture, a light or a sphere"},
           std::pair{"Shift+drag", "Render a rectangle alone (Esc: all)"},
           std::pair{"Alt+drag", "Move the camera around the scene"},
           std::pair{"Ctrl+drag", "Look around"},
           std::pair{"Right drag", "Look around; W A S D Q E fly"},
           std::pair{"Middle drag", "Move the picture"},
           std::pair{"Double-click", "On a heading: fill the window"},
           std::pair{"Right-click", "On an option: copy, reset, send to B"},
       })
    actions.add_gesture({hand, label, "Mouse"});
}

}  // namespace

void App::set_compare(CompareMode mode) {
  session_.navigate(
      [&](Document& document) { document.compare = document.compare == mode ? CompareMode::side_by_side : mode; });
}

void App::zoom_to(double zoom) {
  session_.navigate([&](Document& document) {
    document.view.zoom = zoom;
    // One to one is about the picked pixel, which is what one wants to look at.
    const Vec2i size = pictures_.pictures[0].size();
    const auto picked = session_.pixel();
    document.view.middle = {0.5, 0.5};
    if (zoom > 0 && picked && size.x > 0 && size.y > 0)
      document.view.middle = {(picked->x + 0.5) / size.x, (picked->y + 0.5) / size.y};
  });
}

void App::nudge(Vec2i by) {
  const auto picked = session_.pixel();
  const View view = session_.view();
  if (!picked) {
    session_.set_pixel(Vec2i(view.width / 2, view.height / 2));
    return;
  }
  session_.set_pixel(
      Vec2i(std::clamp(picked->x + by.x, 0, view.width - 1), std::clamp(picked->y + by.y, 0, view.height - 1)));
}

void App::orbit(double right, double up) {
  const Vec3d centre = scene_centre(session_.scene());
  const Camera next = orbited(session_.view().camera, right, up, session_.scene().camera.up, centre);
  session_.edit("orbit", "orbit by keys", [&](Document& document) { document.view.camera = next; });
}

void App::turn(double right, double up) {
  const Camera next = turned(session_.view().camera, right, up, session_.scene().camera.up);
  session_.edit("turn the camera", "turn", [&](Document& document) { document.view.camera = next; });
}

void App::next_channel(int by) {
  const int count = static_cast<int>(shown_channels().size());
  session_.edit("show another channel", "channel", [&](Document& document) {
    const int next = (static_cast<int>(document.a.show) + by + count) % count;
    document.a.show = document.b.show = static_cast<ShownChannel>(next);
  });
}

void App::add_actions() {
  auto& actions = shell_.actions();
  const auto open_scene = [this] { return session_.has_scene(); };
  actions.add({.name = "open", .label = "Open a scene file...", .group = "Scene", .keys = "Ctrl+O", .run = [this] {
                 files_.ask(FilePurpose::open_scene);
               }});
  actions.add({.name = "reload",
               .label = "Reload the scene",
               .group = "Scene",
               .keys = "Ctrl+R",
               .run = [this] { session_.reload(); },
               .enabled = open_scene});
  actions.add({.name = "save-picture",
               .label = "Save the pictures...",
               .group = "Scene",
               .keys = "P",
               .run = [this] { files_.ask(FilePurpose::save_picture); },
               .enabled = open_scene});
  actions.add({.name = "save-scene",
               .label = "Save the scene with its changes...",
               .group = "Scene",
               .keys = "Ctrl+S",
               .run = [this] { files_.ask(FilePurpose::save_scene); },
               .enabled = open_scene});
  actions.add({.name = "save-story",
               .label = "Save the pixel's story...",
               .group = "Scene",
               .run = [this] { files_.ask(FilePurpose::save_story, "story.md"); },
               .enabled = [this] { return session_.story(inspected_side(session_)) != nullptr; }});
  actions.add({.name = "picture-b",
               .label = "Compare with a picture file...",
               .group = "Scene",
               .run = [this] { files_.ask(FilePurpose::compare_picture); },
               .enabled = open_scene});
  actions.add({.name = "drop-picture-b",
               .label = "Render B again instead of the file",
               .group = "Scene",
               .run = [this] { session_.close_picture_b(); },
               .enabled = [this] { return session_.picture_b() != nullptr; }});
  actions.add({.name = "copy-permalink",
               .label = "Copy permalink",
               .group = "Scene",
               .keys = "C",
               .run =
                   [this] {
                     shell_.set_clipboard(session_.permalink());
                     session_.say(Message::Kind::information,
                                  "The permalink is on the clipboard. 'pixelscope-cli render --permalink TEXT --out "
                                  "FILE.png' renders the picture; 'pixelscope --permalink TEXT' opens the window.");
                   },
               .enabled = open_scene});
  actions.add({.name = "copy-command",
               .label = "Copy the command that renders this picture",
               .group = "Scene",
               .keys = "Shift+C",
               .run = [this] { copy_command(linked_command(session_.document(), LinkedCommand::render)); },
               .enabled = open_scene});
  actions.add({.name = "copy-inspect-command",
               .label = "Copy the command that prints this pixel's story",
               .group = "Scene",
               .run = [this] { copy_command(linked_command(session_.document(), LinkedCommand::inspect)); },
               .enabled = [this] { return session_.has_scene() && session_.document().pixel.x >= 0; }});
  actions.add({.name = "copy-window-command",
               .label = "Copy the command that opens this screen",
               .group = "Scene",
               .run = [this] { copy_command(window_command(session_.document())); },
               .enabled = open_scene});
  actions.add({.name = "save-screen",
               .label = "Save the screen as a file...",
               .group = "Scene",
               .keys = "Ctrl+Shift+S",
               .run = [this] { files_.ask(FilePurpose::save_permalink); },
               .enabled = open_scene});
  actions.add({.name = "undo",
               .label = "Undo",
               .group = "Edit",
               .keys = "Ctrl+Z",
               .kind = ActionKind::repeat,
               .run = [this] { session_.undo(); },
               .enabled = [this] { return session_.can_undo(); }});
  actions.add({.name = "redo",
               .label = "Redo",
               .group = "Edit",
               .keys = "Ctrl+Shift+Z Ctrl+Y",
               .kind = ActionKind::repeat,
               .run = [this] { session_.redo(); },
               .enabled = [this] { return session_.can_redo(); }});
  actions.add({.name = "history",
               .label = "History: every step with its pictures",
               .group = "Edit",
               .keys = "Y",
               .run =
                   [this] {
                     history_.open = !history_.open;
                     if (history_.open) session_.navigate([](Document& document) { document.layout.panels = true; });
                   },
               .checked = [this] { return history_.open; }});
  add_view_actions();
  add_pixel_actions();
  add_story_actions();
  add_camera_actions();
  add_lesson_actions();
  add_study_actions();
}

void App::add_view_actions() {
  auto& actions = shell_.actions();
  const auto not_flying = [this] { return !flying(pictures_); };
  const auto compare = [&](const char* name, const char* label, const char* keys, CompareMode mode) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Compare",
                 .keys = keys,
                 .run = [this, mode] { set_compare(mode); },
                 .enabled = not_flying,
                 .checked = [this, mode] { return session_.document().compare == mode; }});
  };
  actions.add(
      {.name = "side-by-side",
       .label = "Side by side",
       .group = "Compare",
       .keys = "",
       .run = [this] { session_.navigate([](Document& document) { document.compare = CompareMode::side_by_side; }); },
       .checked = [this] { return session_.document().compare == CompareMode::side_by_side; }});
  compare("split", "Split: drag the divider", "X", CompareMode::split);
  compare("difference", "Difference B - A", "D", CompareMode::difference);
  compare("only-a", "Only A", "", CompareMode::only_a);
  compare("only-b", "Only B", "", CompareMode::only_b);
  actions.add({.name = "flicker",
               .label = "Flicker: A and B change places while held",
               .group = "Compare",
               .keys = "F",
               .kind = ActionKind::hold,
               .run_hold = [this](bool on) { pictures_.flip = on; },
               .enabled = not_flying});
  actions.add({.name = "loupe",
               .label = "Loupe while held",
               .group = "View",
               .keys = "Z",
               .kind = ActionKind::hold,
               .run_hold = [this](bool on) { pictures_.loupe = on; },
               .enabled = not_flying});
  actions.add({.name = "fit", .label = "Fit the picture", .group = "View", .keys = "0", .run = [this] { zoom_to(0); }});
  actions.add(
      {.name = "one-to-one", .label = "One to one", .group = "View", .keys = "1", .run = [this] { zoom_to(1); }});
  const auto zoom_by = [this](double factor) {
    zoom_to(std::clamp(pictures_.transform.zoom * factor, smallest_zoom, largest_zoom));
  };
  actions.add({.name = "zoom-in",
               .label = "Zoom in on the pixel",
               .group = "View",
               .keys = "=",
               .kind = ActionKind::repeat,
               .run = [zoom_by] { zoom_by(2); }});
  actions.add({.name = "zoom-out",
               .label = "Zoom out",
               .group = "View",
               .keys = "-",
               .kind = ActionKind::repeat,
               .run = [zoom_by] { zoom_by(0.5); }});
  actions.add({.name = "grid",
               .label = "Grid and numbers in large pixels",
               .group = "View",
               .keys = "G",
               .run = [this] { pictures_.grid = !pictures_.grid; },
               .checked = [this] { return pictures_.grid; }});
  actions.add({.name = "handles",
               .label = "Handles of lights and spheres",
               .group = "View",
               .keys = "H",
               .run = [this] { pictures_.handles = !pictures_.handles; },
               .checked = [this] { return pictures_.handles; }});
  actions.add({.name = "channel-next", .label = "Next channel", .group = "View", .keys = "N", .run = [this] {
                 next_channel(1);
               }});
  actions.add(
      {.name = "channel-before", .label = "Previous channel", .group = "View", .keys = "Shift+N", .run = [this] {
         next_channel(-1);
       }});
  actions.add(
      {.name = "panels",
       .label = "Panels",
       .group = "View",
       .keys = "Tab",
       .run =
           [this] { session_.navigate([](Document& document) { document.layout.panels = !document.layout.panels; }); },
       .checked = [this] { return session_.document().layout.panels; }});
}

void App::add_pixel_actions() {
  auto& actions = shell_.actions();
  struct Direction {
    const char *name, *label, *key;
    Vec2i by;
  };
  for (const auto& [name, label, key, by] :
       {Direction{"left", "left", "Left", {-1, 0}}, Direction{"right", "right", "Right", {1, 0}},
        Direction{"up", "up", "Up", {0, -1}}, Direction{"down", "down", "Down", {0, 1}}}) {
    actions.add({.name = fmt::format("pixel-{}", name),
                 .label = fmt::format("Pixel {}", label),
                 .group = "Pixel",
                 .keys = key,
                 .kind = ActionKind::repeat,
                 .run = [this, by = by] { nudge(by); }});
    actions.add({.name = fmt::format("pixel-{}-far", name),
                 .label = fmt::format("Ten pixels {}", label),
                 .group = "Pixel",
                 .keys = fmt::format("Shift+{}", key),
                 .kind = ActionKind::repeat,
                 .run = [this, by = by] { nudge(by * far_nudge); }});
  }
}

void App::add_story_actions() {
  auto& actions = shell_.actions();
  actions.add({.name = "predict",
               .label = "Predict: ask before the story is shown",
               .group = "Pixel",
               .keys = "Q",
               .run = [this] { predict_.on = !predict_.on; },
               .checked = [this] { return predict_.on; }});
  const auto there_are_steps = [this] { return !space_.model.steps.empty(); };
  actions.add({.name = "story-play",
               .label = "Play or pause the story",
               .group = "Story",
               .keys = "Space",
               .run = [this] { play_story(session_, space_, pixel_panel_); },
               .enabled = there_are_steps,
               .checked = [this] { return space_.play.running; }});
  const auto step = [&](const char* name, const char* label, const char* keys, int by) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Story",
                 .keys = keys,
                 .kind = ActionKind::repeat,
                 .run = [this, by] { step_story(session_, space_, pixel_panel_, by); },
                 .enabled = there_are_steps});
  };
  step("story-back", "Previous event", ",", -1);
  step("story-forward", "Next event", ".", 1);
}

void App::add_lesson_actions() {
  auto& actions = shell_.actions();
  actions.offer_more([this] { return palette_entries(); });
  const auto in_lesson = [this] { return !session_.document().lesson.empty(); };
  const auto add = [&](const char* name, const char* label, const char* keys, std::function<void()> run,
                       std::function<bool()> enabled) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Lesson",
                 .keys = keys,
                 .run = std::move(run),
                 .enabled = std::move(enabled)});
  };
  add(
      "step-next", "Next step", "Enter PageDown", [this] { move_step(session_, lessons_, 1); }, in_lesson);
  add(
      "step-before", "Previous step", "PageUp", [this] { move_step(session_, lessons_, -1); }, in_lesson);
  add(
      "lesson-read-on", "Read on, then the next step", "Shift+PageDown", [this] { read_lesson(session_, lessons_, 1); },
      in_lesson);
  add(
      "lesson-read-back", "Read back, then the previous step", "Shift+PageUp",
      [this] { read_lesson(session_, lessons_, -1); }, in_lesson);
  add("lesson-after", "Next lesson", "]", [this] { move_lesson(session_, 1); }, {});
  add("lesson-before", "Previous lesson", "[", [this] { move_lesson(session_, -1); }, {});
  add(
      "lesson-close", "Close the lesson", "", [this] { close_lesson(session_); }, in_lesson);
}

void App::add_camera_actions() {
  auto& actions = shell_.actions();
  struct Turn {
    const char *name, *label, *keys;
    double right, up;
  };
  for (const Turn& by :
       {Turn{"turn-left", "Turn left", "Ctrl+Left", -1, 0}, Turn{"turn-right", "Turn right", "Ctrl+Right", 1, 0},
        Turn{"turn-up", "Turn up", "Ctrl+Up", 0, 1}, Turn{"turn-down", "Turn down", "Ctrl+Down", 0, -1}})
    actions.add({.name = by.name,
                 .label = by.label,
                 .group = "Camera",
                 .keys = by.keys,
                 .kind = ActionKind::repeat,
                 .run = [this, by] { turn(by.right * turn_step, by.up * turn_step); }});
  // As Alt and a drag do. The camera goes where the key says, so that the scene turns the other way.
  for (const Turn& by : {Turn{"orbit-left", "Go left around the scene", "Alt+Left", 1, 0},
                         Turn{"orbit-right", "Go right around the scene", "Alt+Right", -1, 0},
                         Turn{"orbit-up", "Go up around the scene", "Alt+Up", 0, -1},
                         Turn{"orbit-down", "Go down around the scene", "Alt+Down", 0, 1}})
    actions.add({.name = by.name,
                 .label = by.label,
                 .group = "Camera",
                 .keys = by.keys,
                 .kind = ActionKind::repeat,
                 .run = [this, by] { orbit(by.right * turn_step, by.up * turn_step); }});
  actions.add({.name = "fly",
               .label = "Fly: W A S D Q E move the camera",
               .group = "Camera",
               .keys = "`",
               .run = [this] { pictures_.fly = !pictures_.fly; },
               .checked = [this] { return pictures_.fly; }});
  actions.add({.name = "reset-view", .label = "Reset camera and zoom", .group = "Camera", .keys = "R", .run = [this] {
                 session_.edit("reset the camera", [](Document& document) { document.view.camera.reset(); });
                 zoom_to(0);
               }});
  struct Push {
    const char *name, *label, *keys;
    double right, up, forward;
  };
  for (const Push& by :
       {Push{"light-away", "Light away from the camera", "I", 0, 0, 1},
        Push{"light-near", "Light nearer", "K", 0, 0, -1}, Push{"light-left", "Light left", "J", -1, 0, 0},
        Push{"light-right", "Light right", "L", 1, 0, 0}, Push{"light-down", "Light down", "U", 0, -1, 0},
        Push{"light-up", "Light up", "O", 0, 1, 0}})
    actions.add(
        {.name = by.name,
         .label = by.label,
         .group = "Light",
         .keys = by.keys,
         .kind = ActionKind::repeat,
         .run = [this, by] { move_light(by.right * light_share, by.up * light_share, by.forward * light_share); },
         .enabled =
             [this] {
               return selected_light(session_.scene(), options_panel_.selected_light) <
                      static_cast<int>(session_.scene().lights->size());
             }});
  add_gestures(actions);
}

}  // namespace ps::gui
