#include <fmt/format.h>

#include <utility>

#include "document/number_list.h"
#include "document/permalink.h"
#include "gui/frame/app.h"
#include "gui/shell/values.h"
#include "options/option.h"

namespace ps::gui {
namespace {

/// FNV-1a over the displayed levels: equal pictures have equal hashes, on every machine.
std::uint64_t picture_hash(const Image<Rgb8>& levels) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&](std::uint8_t byte) { hash = (hash ^ byte) * 1099511628211ull; };
  for (const Rgb8& level : levels.pixels()) {
    add(level.r);
    add(level.g);
    add(level.b);
  }
  return hash;
}

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

bool rendering(RenderState state) { return state == RenderState::coarse || state == RenderState::full; }

std::string colour_text(const std::array<int, 3>& display) {
  return fmt::format("{} {} {}", display[0], display[1], display[2]);
}

void publish_side(Session& session, const PicturesState& pictures, Side side) {
  Values& out = values();
  const std::string name = side == Side::a ? "a/" : "b/";
  const auto status = session.renderer(side).status();
  const auto result = session.renderer(side).result();
  out.publish(name + "state", state_word(status.state));
  out.publish(name + "renders", status.renders_done);
  out.publish(name + "first-pixels-ms", status.first_pixels);
  const auto& levels = pictures.pictures[index_of(side)].levels;
  out.publish(name + "picture", fmt::format("{:016x}", pictures.hashes[index_of(side)]));
  out.publish(name + "size", fmt::format("{}x{}", levels.width(), levels.height()));
  out.publish(name + "show", shown_channel(session.shown(side)).key);
  std::string changed;
  for (const auto& assignment : changed_options(session.settings(side)))
    changed += (changed.empty() ? "" : " ") + assignment;
  out.publish(name + "settings", changed);
  for (const auto& option : option_table())
    out.publish(name + "option/" + std::string(option.key), option_text(option, session.settings(side)));
  if (result)
    for (std::size_t i = 0; i < counter_count; ++i) {
      const auto counter = static_cast<Counter>(i);
      const auto count = result->frame.counters.get(counter);
      out.publish(name + "counter/" + std::string(counter_key(counter)), count ? std::to_string(*count) : "none");
    }
  const auto story = session.story(side);
  out.publish(name + "verdict", story ? story->verdict : "");
  out.publish(name + "colour", story ? colour_text(story->display) : "");
  out.publish(name + "events", story ? static_cast<int>(story->events.size()) : 0);
}

void publish_vector(const std::string& name, const Vec3d& v) {
  values().publish(name + "/x", v.x);
  values().publish(name + "/y", v.y);
  values().publish(name + "/z", v.z);
}

/// Where camera and lights are now.
void publish_places(const Session& session) {
  const Camera camera = session.view().camera;
  publish_vector("camera/position", camera.position);
  publish_vector("camera/forward", camera.forward);
  publish_vector("camera/up", camera.up);
  const auto& lights = *session.scene().lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const bool has_place = lights[i].kind == LightKind::point;
    publish_vector(fmt::format("light/{}", i), has_place ? lights[i].position : lights[i].direction);
  }
}

}  // namespace

/// What scripts and tests may ask for.
void App::publish() {
  Values& out = values();
  for (const Side side : both_sides) {
    // Not while tiles arrive: large pictures take long to add up.
    if (pictures_.fresh[index_of(side)] && !rendering(session_.renderer(side).status().state)) {
      pictures_.hashes[index_of(side)] = picture_hash(pictures_.pictures[index_of(side)].levels);
      pictures_.fresh[index_of(side)] = false;
    }
    publish_side(session_, pictures_, side);
  }
  if (std::exchange(pictures_.difference_fresh, false))
    pictures_.difference_hash = picture_hash(pictures_.difference.levels);
  out.publish("difference/levels", fmt::format("{:016x}", pictures_.difference_hash));
  const auto measured = pictures_.meter->result();
  out.publish("difference/measured",
              measured ? fmt::format("{}", error_of(measured->comparison, pictures_.difference_metric)) : "none");
  const Document& document = session_.document();
  out.publish("scene", document.scene_name);
  out.publish("loading", session_.loading() ? session_.loading_name() : "none");
  out.publish("compare", compare_key(document.compare));
  out.publish("identical", pictures_.hashes[0] == pictures_.hashes[1]);
  const auto picked = session_.pixel();
  out.publish("pixel", picked ? fmt::format("{},{}", picked->x, picked->y) : "none");
  const auto& region = session_.region();
  out.publish("region", region ? region_text(*region) : "all");
  out.publish("picture-b", document.picture_b.empty() ? "none" : document.picture_b);
  out.publish("picked", std::string(1, letter_of(document.picked)));
  out.publish("permalink", session_.permalink());
  out.publish("undo", session_.undo_label());
  out.publish("redo", session_.redo_label());
  const History* history = session_.history();
  out.publish("history/steps", history ? static_cast<int>(history->entries().size()) : 0);
  out.publish("history/step", history ? static_cast<int>(history->place()) + 1 : 0);
  out.publish("history/open", history_.open);
  out.publish("messages", static_cast<int>(session_.messages().size()));
  out.publish("message", session_.messages().empty() ? "" : session_.messages().back().text);
  out.publish("zoom", pictures_.transform.zoom);
  out.publish("middle", fmt::format("{:.6f},{:.6f}", document.view.middle.x, document.view.middle.y));
  out.publish("split", document.split);
  publish_places(session_);
  out.publish("flying", flying(pictures_));
  out.publish("flicker", pictures_.flip);
  out.publish("lesson", document.lesson);
  out.publish("step", document.lesson.empty() ? 0 : document.step + 1);
  out.publish("first-look/offered", offers_first_look_);
  out.publish("panels", document.layout.panels);
  out.publish("selected-event", pixel_panel_.cursors[index_of(inspected_side(session_))].selected);
  out.publish("space/items", space_.items);
  out.publish("space/rays", space_.rays);
  out.publish("space/shadow-rays", space_.shadow_rays);
  out.publish("space/boxes", space_.boxes);
  out.publish("space/tree-nodes", space_.tree ? static_cast<int>(space_.tree->nodes) : 0);
  out.publish("space/steps", static_cast<int>(space_.model.steps.size()));
  out.publish("space/playing", space_.play.running);
  out.publish("space/up-to", space_.play.up_to);
  out.publish("space/orbit", space_.orbit ? fmt::format("{:.6g} {:.6g} {:.6g}", space_.orbit->yaw, space_.orbit->pitch,
                                                        space_.orbit->distance)
                                          : "none");
  out.publish("listing/focus", listing_.view ? listing_.view->focus() : -1);
  out.publish("listing/folder", listing_.shown_story && listing_.shown_story->listing
                                    ? listing_.shown_story->listing->listing.folder
                                    : "");
  out.publish("listing/values", listing_.shown_story && listing_.shown_story->listing
                                    ? static_cast<int>(listing_.shown_story->listing->watches.size())
                                    : 0);
  out.publish("predict/points", predict_.points);
  out.publish("predict/asked", predict_.asked);
  out.publish("vertex", vertex_.vertex ? fmt::format("{},{}", vertex_.vertex->object, vertex_.vertex->vertex) : "none");
  out.publish("space/filled", filling() == "bottom");
  studies_.publish();
}

}  // namespace ps::gui
