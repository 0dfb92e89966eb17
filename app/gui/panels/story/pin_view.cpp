#include "gui/panels/story/pin_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "gui/widgets/draw.h"
#include "options/scene_settings.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

constexpr std::size_t most_gone = 20;  // listed at once

/// "0.4 → 0.3", or one text where both are equal.
std::string both_text(const std::string& before, const std::string& after) {
  return before == after ? after : fmt::format("{} → {}", before, after);
}

PinnedStory compared(const std::shared_ptr<const PixelStory>& before, const PixelStory& after, const Scene& scene) {
  PinnedStory pinned{before, story_changes(*before, after, scene), std::vector<int>(after.events.size(), 0), {}};
  for (std::size_t i = 0; i < pinned.changes.steps.size(); ++i)
    if (const int event = pinned.changes.steps[i].after; event >= 0)
      pinned.steps[static_cast<std::size_t>(event)] = static_cast<int>(i);
  // Lines that are there now keep their order.
  for (std::size_t i = 0; i < pinned.changes.ledger.size(); ++i)
    if (pinned.changes.ledger[i].after) pinned.terms.push_back(static_cast<int>(i));
  return pinned;
}

/// Events that are gone with all above them still there: what was below goes without saying.
void gone_events(const PinnedStory& pinned) {
  std::size_t listed = 0, left_out = 0;
  int below = -1;  // depth of the last one that is gone
  for (const StepChange& step : pinned.changes.steps) {
    if (step.after >= 0) {
      below = -1;
      continue;
    }
    if (below >= 0 && step.depth > below) continue;
    below = step.depth;
    if (listed == most_gone) {
      ++left_out;
      continue;
    }
    value_paragraph(fmt::format("gone/{}", listed++), "gone: " + step.text, {.quiet = true});
  }
  if (left_out > 0) quiet_text(fmt::format("and {} more that are gone", left_out));
}

/// "red moved to (0.4, -0.9, 3)", "light 2 (point): intensity 0.3", or the edit as it is.
std::string edit_words(const Scene& scene, const SceneEdit& edit) {
  const std::size_t dot = edit.path.find('.'), end = edit.path.find('.', dot + 1);
  const std::string kind = edit.path.substr(0, dot);
  int index = 0;
  if (end == std::string::npos || (kind != "object" && kind != "light") ||
      std::from_chars(&edit.path[dot + 1], &edit.path[end], index).ptr != &edit.path[end])
    return edit.path + "=" + edit.value;
  const std::string name = kind == "object" ? object_name(scene, index) : light_name(scene, index);
  const std::string property = edit.path.substr(end + 1);
  constexpr std::array<std::string_view, 4> places{"center", "corner", "position", "translation"};
  const bool moved = std::find(places.begin(), places.end(), property) != places.end();
  return name + (moved ? " moved to " : ": " + property + " ") + edit.value;
}

/// The user's changes since the pixel was pinned: "reflection-depth=1, camera".
std::string changes_since(const Session& session, Side side) {
  const Document& document = session.document();
  const Pin& pin = *document.pin;
  std::vector<std::string> changed =
      settings_difference(side == Side::a ? pin.a : pin.b, side_of(document, side).settings);
  if (pin.camera != document.view.camera) changed.emplace_back("camera");
  if (pin.width != document.view.width || pin.height != document.view.height) changed.emplace_back("size");
  for (const SceneEdit& edit : document.edits)
    if (std::find(pin.edits.begin(), pin.edits.end(), edit) == pin.edits.end())
      changed.push_back(edit_words(session.scene(), edit));
  return fmt::format("{}", fmt::join(changed, ", "));
}

}  // namespace

PinState::PinState(const std::function<void()>& wake) : prepared(std::make_shared<Prepared>()) {
  for (auto& worker : workers) worker = std::make_unique<InspectWorker>(prepared, wake);
}

void update_pin(Session& session, PinState& state) {
  for (const auto& worker : state.workers) worker->take_news();
  const Document& document = session.document();
  if (!document.pin) {
    for (const auto& worker : state.workers) worker->clear();
    return;
  }
  const Pin& pin = *document.pin;
  if (state.shown_pin == pin && state.shown_scene == document.scene_name) {
    for (const Side side : both_sides)
      if (auto& pinned = state.pinned[index_of(side)]; !pinned) pinned = state.workers[index_of(side)]->story();
    if (!pin_busy(state)) state.prepared->clear();
    return;
  }
  state.shown_pin = pin;
  state.shown_scene = document.scene_name;
  state.pinned = {};
  state.compared = {};
  Document now = document;
  pin_pixel(now);
  for (const Side side : both_sides) {
    const std::size_t index = index_of(side);
    state.workers[index]->clear();
    if (now.pin == pin && !session.work().inspector(side).busy()) state.pinned[index] = session.story(side);
    if (state.pinned[index]) continue;
    PinnedScene then = pinned_scene(pin, document.base);
    state.workers[index]->request(
        {{std::move(then.scene), then.view, side == Side::a ? pin.a : pin.b, {}, {}, {}}, pin.pixel});
  }
}

bool pin_busy(const PinState& state) {
  return std::any_of(state.workers.begin(), state.workers.end(),
                     [](const auto& worker) { return worker->busy() || worker->has_news(); });
}

void pin_button(Session& session) {
  const bool pinned = session.document().pin.has_value();
  const char* tooltip =
      pinned ? "Unpins the pixel." : "Keeps the numbers of this pixel. Change an option to see old → new.";
  if (!button_on_off("pin", pinned ? "Pinned" : "Pin", pinned, {.tooltip = tooltip})) return;
  if (pinned)
    session.edit("unpin the pixel", [](Document& document) { document.pin.reset(); });
  else
    session.edit("pin the pixel", pin_pixel);
}

const PinnedStory* pinned_story(const Session& session, PinState& state, Side side,
                                const std::shared_ptr<const PixelStory>& story) {
  const std::size_t index = index_of(side);
  const auto& pinned = state.pinned[index];
  if (!session.document().pin || !pinned || !story || pinned->pixel != story->pixel) return nullptr;
  if (state.compared[index] != story) {
    state.compared[index] = story;
    state.stories[index] = compared(pinned, *story, session.scene());
  }
  return &state.stories[index];
}

void pin_view(Session& session, PinState& state, Side side, const std::shared_ptr<const PixelStory>& story) {
  const std::size_t index = index_of(side);
  const auto& pinned = state.pinned[index];
  if (!session.document().pin || !pinned || !story) return;
  const NameScope scope("pin");
  if (pinned->pixel != story->pixel) {
    show_paragraph(fmt::format("Pixel ({}, {}) is pinned; this is another one.", pinned->pixel.x, pinned->pixel.y));
    ImGui::SameLine();
    if (button("back", "Go there", Emphasis::quiet)) session.set_pixel(pinned->pixel);
    return;
  }
  const StoryChanges& changes = pinned_story(session, state, side, story)->changes;
  const std::string note = changes.changed_steps == 0 ? "nothing"
                                                      : fmt::format("{} event{}", changes.changed_steps,
                                                                    changes.changed_steps == 1 ? "" : "s");
  if (!section("changes", "Changed since the pin", state.open[index], note)) return;
  const std::string changed = changes_since(session, side);
  value_paragraph("options", changed.empty() ? "No option has changed since then." : "Since then: " + changed);
  const auto& old = changes.display_before;
  const auto& now = changes.display_after;
  value_paragraph("display", (old == now ? "The colour has not changed: " : "Colour: ") +
                                 both_text(fmt::format("{} {} {}", old[0], old[1], old[2]),
                                           fmt::format("{} {} {}", now[0], now[1], now[2])));
  gone_events(state.stories[index]);
  ImGui::Spacing();
}

}  // namespace ps::gui
