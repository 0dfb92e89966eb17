#include "gui/panels/pictures/picture_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "document/permalink.h"
#include "gui/panels/pictures/first_nan.h"
#include "gui/session/camera_moves.h"
#include "render/channel_picture.h"

namespace ps::gui {
namespace {

constexpr double turn_step = 5 * std::numbers::pi / 180;  // radians for one press
constexpr int far_nudge = 10;                             // pixels, with Shift

void set_compare(Session& session, CompareMode mode) {
  session.navigate(
      [&](Document& document) { document.compare = document.compare == mode ? CompareMode::side_by_side : mode; });
}

void zoom_to(Session& session, const PicturesState& pictures, double zoom) {
  session.navigate([&](Document& document) {
    document.view.zoom = zoom;
    // One to one is about the picked pixel, which is what one wants to look at.
    const Vec2i size = pictures.pictures[0].size();
    const auto picked = session.pixel();
    document.view.middle = {0.5, 0.5};
    if (zoom > 0 && picked && size.x > 0 && size.y > 0)
      document.view.middle = {(picked->x + 0.5) / size.x, (picked->y + 0.5) / size.y};
  });
}

void nudge(Session& session, Vec2i by) {
  const auto picked = session.pixel();
  const View view = session.view();
  if (!picked) {
    session.set_pixel(Vec2i(view.width / 2, view.height / 2));
    return;
  }
  session.set_pixel(
      Vec2i(std::clamp(picked->x + by.x, 0, view.width - 1), std::clamp(picked->y + by.y, 0, view.height - 1)));
}

void orbit(Session& session, double right, double up) {
  const Vec3d centre = scene_centre(session.scene());
  const Camera next = orbited(session.view().camera, right, up, session.scene().camera.up, centre);
  session.edit("orbit", "orbit by keys", [&](Document& document) { document.view.camera = next; });
}

void turn(Session& session, double right, double up) {
  const Camera next = turned(session.view().camera, right, up, session.scene().camera.up);
  session.edit("turn the camera", "turn", [&](Document& document) { document.view.camera = next; });
}

void next_channel(Session& session, int by) {
  const int count = static_cast<int>(shown_channels().size());
  session.edit("show another channel", "channel", [&](Document& document) {
    const int next = (static_cast<int>(document.a.show) + by + count) % count;
    document.a.show = document.b.show = static_cast<ShownChannel>(next);
  });
}

void add_view_actions(Actions& actions, Session& session, PicturesState& pictures) {
  const auto not_flying = [&pictures] { return !flying(pictures); };
  const auto compare = [&](CompareMode mode, const char* label, const char* keys) {
    actions.add({.name = std::string(compare_key(mode)),
                 .label = label,
                 .group = "Compare",
                 .keys = keys,
                 .run = [&session, mode] { set_compare(session, mode); },
                 .enabled = not_flying,
                 .checked = [&pictures, mode] { return pictures.compare == mode; }});
  };
  actions.add(
      {.name = std::string(compare_key(CompareMode::side_by_side)),
       .label = "Side by side",
       .group = "Compare",
       .keys = "",
       .run =
           [&session] { session.navigate([](Document& document) { document.compare = CompareMode::side_by_side; }); },
       .checked = [&pictures] { return pictures.compare == CompareMode::side_by_side; }});
  compare(CompareMode::split, "Split: drag the divider", "X");
  compare(CompareMode::difference, "Difference B - A", "D");
  compare(CompareMode::only_a, "Only A", "");
  compare(CompareMode::only_b, "Only B", "");
  actions.add({.name = "flicker",
               .label = "Flicker: A and B change places while held",
               .group = "Compare",
               .keys = "F",
               .kind = ActionKind::hold,
               .run_hold = [&pictures](bool on) { pictures.flip = on; },
               .enabled = not_flying});
  actions.add({.name = "before",
               .label = "Before the last change, while held",
               .group = "Compare",
               .keys = "Backspace",
               .kind = ActionKind::hold,
               .run_hold = [&pictures](bool on) { pictures.was = on; },
               .enabled = not_flying});
  actions.add({.name = "loupe",
               .label = "Loupe while held",
               .group = "View",
               .keys = "Z",
               .kind = ActionKind::hold,
               .run_hold = [&pictures](bool on) { pictures.loupe = on; },
               .enabled = not_flying});
  actions.add({.name = "fit", .label = "Fit the picture", .group = "View", .keys = "0", .run = [&session, &pictures] {
                 zoom_to(session, pictures, 0);
               }});
  actions.add({.name = "one-to-one", .label = "One to one", .group = "View", .keys = "1", .run = [&session, &pictures] {
                 zoom_to(session, pictures, 1);
               }});
  const auto zoom_by = [&session, &pictures](double factor) {
    zoom_to(session, pictures, std::clamp(pictures.transform.zoom * factor, smallest_zoom, largest_zoom));
  };
  actions.add({.name = "zoom-in",
               .label = "Zoom in on the pixel",
               .group = "View",
               .keys = "= +",
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
               .run = [&pictures] { pictures.grid = !pictures.grid; },
               .checked = [&pictures] { return pictures.grid; }});
  actions.add({.name = "handles",
               .label = "Handles of lights and objects",
               .group = "View",
               .keys = "H",
               .run = [&pictures] { pictures.handles = !pictures.handles; },
               .checked = [&pictures] { return pictures.handles; }});
  actions.add({.name = "gizmo",
               .label = "Gizmo: move, turn and scale the picked object",
               .group = "View",
               .keys = "T",
               .run = [&pictures] { pictures.gizmo = !pictures.gizmo; },
               .checked = [&pictures] { return pictures.gizmo; }});
  actions.add({.name = "channel-next", .label = "Next channel", .group = "View", .keys = "N", .run = [&session] {
                 next_channel(session, 1);
               }});
  actions.add(
      {.name = "channel-before", .label = "Previous channel", .group = "View", .keys = "Shift+N", .run = [&session] {
         next_channel(session, -1);
       }});
  actions.add({.name = "panels",
               .label = "Panels",
               .group = "View",
               .keys = "Tab",
               .run =
                   [&session] {
                     session.navigate([](Document& document) { document.layout.panels = !document.layout.panels; });
                   },
               .checked = [&session] { return session.document().layout.panels; }});
}

void add_pixel_actions(Actions& actions, Session& session) {
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
                 .run = [&session, by = by] { nudge(session, by); }});
    actions.add({.name = fmt::format("pixel-{}-far", name),
                 .label = fmt::format("Ten pixels {}", label),
                 .group = "Pixel",
                 .keys = fmt::format("Shift+{}", key),
                 .kind = ActionKind::repeat,
                 .run = [&session, by = by] { nudge(session, by * far_nudge); }});
  }
}

void add_nan_action(Actions& actions, Session& session) {
  actions.add({.name = "first-nan",
               .label = "Go to the first pixel that is not finite: NaN or infinite",
               .group = "Pixel",
               .keys = "Ctrl+N",
               .run = [&session] { go_to_first_nan(session); },
               .enabled = [&session] { return session.has_scene(); }});
}

void add_camera_actions(Actions& actions, Session& session, PicturesState& pictures) {
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
                 .run = [&session, by] { turn(session, by.right * turn_step, by.up * turn_step); }});
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
                 .run = [&session, by] { orbit(session, by.right * turn_step, by.up * turn_step); }});
  actions.add({.name = "fly",
               .label = "Fly: keys move the camera",
               .group = "Camera",
               .keys = "`",
               .run = [&pictures] { pictures.fly = !pictures.fly; },
               .checked = [&pictures] { return pictures.fly; }});
  actions.add({.name = "reset-view",
               .label = "Reset camera and zoom",
               .group = "Camera",
               .keys = "R",
               .run = [&session, &pictures] {
                 session.edit("reset the camera", [](Document& document) { document.view.camera.reset(); });
                 zoom_to(session, pictures, 0);
               }});
}

}  // namespace

void add_picture_actions(Actions& actions, Session& session, PicturesState& pictures) {
  add_view_actions(actions, session, pictures);
  add_pixel_actions(actions, session);
  add_nan_action(actions, session);
  add_camera_actions(actions, session, pictures);
  add_slow_motion_actions(actions, session, pictures.slow, [&pictures] { return !flying(pictures); });
}

}  // namespace ps::gui
