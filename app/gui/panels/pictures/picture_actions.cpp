#include "gui/panels/pictures/picture_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/enumerators.h"
#include "document/permalink.h"
#include "gui/panels/pictures/first_nan.h"
#include "gui/panels/pictures/picture_size.h"
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

void add_compare_actions(Actions& actions, Session& session, PicturesState& pictures) {
  const auto not_flying = [&pictures] { return !flying(pictures); };
  const auto add = [&](CompareMode mode, const char* label, const char* keys, std::function<void()> run,
                       std::function<bool()> enabled) {
    ActionGroup(actions, "Compare", std::move(enabled))
        .add_toggle(std::string(enumerator_key(mode)), label, keys, std::move(run),
                    [&pictures, mode] { return pictures.drawn.compare == mode; });
  };
  const auto compare = [&](CompareMode mode, const char* label, const char* keys) {
    add(
        mode, label, keys, [&session, mode] { set_compare(session, mode); }, not_flying);
  };
  const auto beside = [&session] {
    session.navigate([](Document& document) { document.compare = CompareMode::side_by_side; });
  };
  add(CompareMode::side_by_side, "Side by side", "", beside, {});
  compare(CompareMode::split, "Split: drag the divider", "X");
  compare(CompareMode::difference, "Difference B - A", "D");
  compare(CompareMode::only_a, "Only A", "");
  compare(CompareMode::only_b, "Only B", "");
  const auto hold = [&](const char* name, const char* label, const char* group, const char* keys, bool& held) {
    actions.add({.name = name,
                 .label = label,
                 .group = group,
                 .keys = keys,
                 .kind = ActionKind::hold,
                 .run_hold = [&held](bool on) { held = on; },
                 .enabled = not_flying});
  };
  hold("flicker", "Flicker: A and B change places while held", "Compare", "F", pictures.keys.flip);
  hold("before", "Before the last change, while held", "Compare", "Backspace", pictures.keys.was);
  hold("loupe", "Loupe while held", "View", "Z", pictures.keys.loupe);
}

void add_view_actions(Actions& actions, Session& session, PicturesState& pictures) {
  ActionGroup view(actions, "View");
  view.add("fit", "Fit the picture", "0", [&session, &pictures] { zoom_to(session, pictures, 0); });
  view.add("one-to-one", "One to one", "1", [&session, &pictures] { zoom_to(session, pictures, 1); });
  const auto zoom_by = [&session, &pictures](double factor) {
    zoom_to(session, pictures, std::clamp(pictures.drawn.transform.zoom * factor, smallest_zoom, largest_zoom));
  };
  view.add_repeated("zoom-in", "Zoom in on the pixel", "= +", [zoom_by] { zoom_by(2); });
  view.add_repeated("zoom-out", "Zoom out", "-", [zoom_by] { zoom_by(0.5); });
  const auto flag = [&](const char* name, const char* label, const char* keys, bool& on) {
    view.add_toggle(
        name, label, keys, [&on] { on = !on; }, [&on] { return on; });
  };
  flag("grid", "Grid and numbers in large pixels", "G", pictures.grid);
  flag("handles", "Handles of lights and objects", "H", pictures.handles);
  flag("projected-vertices", "Projected vertices over the picture, with their numbers in large pixels", "Shift+V",
       pictures.vertices.on);
  flag("gizmo", "Gizmo: move, turn and scale the picked object", "T", pictures.selection.gizmo);
  view.add("channel-next", "Next channel", "N", [&session] { next_channel(session, 1); });
  view.add("channel-before", "Previous channel", "Shift+N", [&session] { next_channel(session, -1); });
  view.add_toggle(
      "panels", "Panels", "Tab",
      [&session] { session.navigate([](Document& document) { document.layout.panels = !document.layout.panels; }); },
      [&session] { return session.document().layout.panels; });
}

void add_pixel_actions(Actions& actions, Session& session) {
  struct Direction {
    const char *name, *key;
    Vec2i by;
  };
  ActionGroup group(actions, "Pixel");
  for (const auto& [name, key, by] : {Direction{"left", "Left", {-1, 0}}, Direction{"right", "Right", {1, 0}},
                                      Direction{"up", "Up", {0, -1}}, Direction{"down", "Down", {0, 1}}}) {
    group.add_repeated(fmt::format("pixel-{}", name), fmt::format("Pixel {}", name), key,
                       [&session, by = by] { nudge(session, by); });
    group.add_repeated(fmt::format("pixel-{}-far", name), fmt::format("Ten pixels {}", name),
                       fmt::format("Shift+{}", key), [&session, by = by] { nudge(session, by * far_nudge); });
  }
  ActionGroup(actions, "Pixel", [&session] {
    return session.has_scene();
  }).add("first-nan", "Go to the first pixel that is not finite: NaN or infinite", "Ctrl+N", [&session] {
    go_to_first_nan(session);
  });
}

void add_camera_actions(Actions& actions, Session& session, PicturesState& pictures) {
  struct Turn {
    const char *name, *label, *keys;
    double right, up;
  };
  ActionGroup camera(actions, "Camera");
  for (const Turn& by :
       {Turn{"turn-left", "Turn left", "Ctrl+Left", -1, 0}, Turn{"turn-right", "Turn right", "Ctrl+Right", 1, 0},
        Turn{"turn-up", "Turn up", "Ctrl+Up", 0, 1}, Turn{"turn-down", "Turn down", "Ctrl+Down", 0, -1}})
    camera.add_repeated(by.name, by.label, by.keys,
                        [&session, by] { turn(session, by.right * turn_step, by.up * turn_step); });
  // As Alt and a drag do. The camera goes where the key says, so that the scene turns the other way.
  for (const Turn& by : {Turn{"orbit-left", "Go left around the scene", "Alt+Left", 1, 0},
                         Turn{"orbit-right", "Go right around the scene", "Alt+Right", -1, 0},
                         Turn{"orbit-up", "Go up around the scene", "Alt+Up", 0, -1},
                         Turn{"orbit-down", "Go down around the scene", "Alt+Down", 0, 1}})
    camera.add_repeated(by.name, by.label, by.keys,
                        [&session, by] { orbit(session, by.right * turn_step, by.up * turn_step); });
  camera.add_toggle(
      "fly", "Fly: keys move the camera", "`", [&pictures] { pictures.keys.fly = !pictures.keys.fly; },
      [&pictures] { return pictures.keys.fly; });
  camera.add("reset-view", "Reset camera and zoom", "R", [&session, &pictures] {
    session.edit("reset the camera", [](Document& document) { document.view.camera.reset(); });
    zoom_to(session, pictures, 0);
  });
}

}  // namespace

void add_picture_actions(Actions& actions, Session& session, PicturesState& pictures) {
  add_compare_actions(actions, session, pictures);
  add_view_actions(actions, session, pictures);
  add_size_actions(actions, session, pictures);
  add_pixel_actions(actions, session);
  add_camera_actions(actions, session, pictures);
  add_slow_motion_actions(actions, session, pictures.slow, [&pictures] { return !flying(pictures); });
}

}  // namespace ps::gui
