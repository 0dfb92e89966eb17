#include "gui/session/session_values.h"

#include <fmt/format.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "document/number_list.h"
#include "document/permalink.h"
#include "gui/base/region_names.h"
#include "options/option.h"
#include "options/waking.h"
#include "scene/edit.h"

namespace ps::gui {
namespace {

std::string_view state_word(RenderState state) {
  switch (state) {
  case RenderState::idle:
    return "idle";
  case RenderState::coarse:
    return "coarse";
  case RenderState::full:
    return "full";
  case RenderState::done:
    return "done";
  case RenderState::cancelled:
    return "cancelled";
  case RenderState::failed:
    return "failed";
  }
  return "idle";
}

std::string settings_text(const Settings& settings) {
  std::string changed;
  for (const auto& assignment : changed_options(settings)) changed += (changed.empty() ? "" : " ") + assignment;
  return changed;
}

std::optional<std::string> option_value(const Settings& settings, std::string_view key) {
  for (const auto& option : option_table())
    if (option.key == key) return option_text(option, settings);
  return {};
}

std::optional<std::string> counter_value(const RenderResult* result, std::string_view key) {
  if (!result) return {};
  for (std::size_t i = 0; i < counter_count; ++i) {
    if (counter_key(static_cast<Counter>(i)) != key) continue;
    const auto count = result->frame.counters.get(static_cast<Counter>(i));
    return count ? script_text(*count) : "none";
  }
  return {};
}

void offer_side(Values& out, Session& session, Side side) {
  const std::string name = side == Side::a ? "a/" : "b/";
  out.offer(name + "state", [&session, side] { return state_word(session.renderer(side).status().state); });
  out.offer(name + "renders", [&session, side] { return session.renderer(side).status().renders_done; });
  out.offer(name + "first-pixels-ms", [&session, side] { return session.renderer(side).status().first_pixels; });
  out.offer(name + "show", [&session, side] { return shown_channel(session.shown(side)).key; });
  out.offer(name + "settings", [&session, side] { return settings_text(session.settings(side)); });
  out.offer_below(name + "option/",
                  [&session, side](std::string_view key) { return option_value(session.settings(side), key); });
  out.offer_below(name + "counter/", [&session, side](std::string_view key) {
    return counter_value(session.renderer(side).result().get(), key);
  });
  out.offer(name + "verdict", [&session, side] {
    const auto story = session.story(side);
    return story ? story->verdict : std::string();
  });
  out.offer(name + "colour", [&session, side] {
    const auto story = session.story(side);
    return story ? fmt::format("{} {} {}", story->display[0], story->display[1], story->display[2]) : std::string();
  });
  out.offer(name + "events", [&session, side] {
    const auto story = session.story(side);
    return story ? static_cast<int>(story->events.size()) : 0;
  });
}

std::optional<std::string> component(const Vec3d& v, std::string_view axis) {
  if (axis == "x") return script_text(v.x);
  if (axis == "y") return script_text(v.y);
  if (axis == "z") return script_text(v.z);
  return {};
}

/// "position/x" of the camera.
std::optional<std::string> camera_value(const Session& session, std::string_view name) {
  const Camera camera = session.view().camera;
  const auto slash = name.find('/');
  const std::string_view what = name.substr(0, slash);
  if (slash == std::string_view::npos) return {};
  const std::string_view axis = name.substr(slash + 1);
  if (what == "position") return component(camera.position, axis);
  if (what == "forward") return component(camera.forward, axis);
  if (what == "up") return component(camera.up, axis);
  return {};
}

/// "0/x": where the first light is, or where it shines.
std::optional<std::string> light_value(const Session& session, std::string_view name) {
  const auto& lights = *session.scene().lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (const std::string number = fmt::format("{}/", i); name.starts_with(number))
      return component(lights[i].kind == LightKind::point ? lights[i].position : lights[i].direction,
                       name.substr(number.size()));
  return {};
}

/// Text of a scene property, by its path in scene/edit.h; nullopt if unknown.
std::optional<std::string> property_value(const Session& session, std::string_view path) {
  try {
    return get_property(session.scene(), path);
  } catch (const InputError&) {
    return {};
  }
}

/// Whether a renderer's driver, if it has one, was started.
std::optional<std::string> started_value(std::string_view renderer) {
  Settings settings;
  try {
    parse_assignment(fmt::format("renderer={}", renderer), settings);
  } catch (const InputError&) {
    return {};
  }
  return has_started(settings.renderer) ? "yes" : "no";
}

void offer_history(Values& out, Session& session) {
  out.offer("undo", [&session] { return session.undo_label(); });
  out.offer("redo", [&session] { return session.redo_label(); });
  out.offer("history/steps",
            [&session] { return session.history() ? static_cast<int>(session.history()->entries().size()) : 0; });
  out.offer("history/step",
            [&session] { return session.history() ? static_cast<int>(session.history()->place()) + 1 : 0; });
  out.offer("messages", [&session] { return static_cast<int>(session.messages().all().size()); });
  out.offer("message",
            [&session] { return session.messages().all().empty() ? "" : session.messages().all().back().text; });
}

}  // namespace

void offer_session_values(Values& out, Session& session) {
  for (const Side side : both_sides) offer_side(out, session, side);
  out.offer_below("camera/", [&session](std::string_view name) { return camera_value(session, name); });
  out.offer_below("light/", [&session](std::string_view name) { return light_value(session, name); });
  out.offer_below("property/", [&session](std::string_view path) { return property_value(session, path); });
  out.offer_below("started/", started_value);
  offer_history(out, session);
  out.offer("scene", [&session] { return session.document().scene_name; });
  out.offer("loading",
            [&session] { return session.loader().loading() ? session.loader().name() : std::string("none"); });
  out.offer("compare", [&session] { return enumerator_key(session.document().compare); });
  out.offer("pixel", [&session] {
    const auto picked = session.pixel();
    return picked ? fmt::format("{},{}", picked->x, picked->y) : "none";
  });
  out.offer("region", [&session] { return session.region() ? region_text(*session.region()) : "all"; });
  out.offer("picture-b", [&session] {
    const std::string& file = session.document().picture_b;
    return file.empty() ? "none" : file;
  });
  out.offer("picked", [&session] { return std::string(1, letter_of(session.document().picked)); });
  out.offer("permalink", [&session] { return session.permalink(); });
  out.offer("middle", [&session] {
    const Vec2d middle = session.document().view.middle;
    return fmt::format("{:.6f},{:.6f}", middle.x, middle.y);
  });
  out.offer("split", [&session] { return session.document().split; });
  out.offer("lesson", [&session] { return session.document().lesson; });
  out.offer("step", [&session] { return session.document().lesson.empty() ? 0 : session.document().step + 1; });
  out.offer("panels", [&session] { return session.document().layout.panels; });
  out.offer("pixel-panel", [&session] { return session.document().layout.story_open; });
  out.offer("mode", [&session] { return enumerator_key(session.document().mode); });
  out.offer("selected-event", [&session] { return session.selected_event(inspected_side(session)); });
  out.offer("space/filled", [&session] { return session.document().layout.filled == region_names::bottom; });
}

}  // namespace ps::gui
