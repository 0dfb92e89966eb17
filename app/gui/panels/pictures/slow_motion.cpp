#include "gui/panels/pictures/slow_motion.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/base/values.h"
#include "gui/widgets/redraw.h"
#include "render/slow_motion.h"

namespace ps::gui {
namespace {

constexpr double frame_seconds = 1.0 / 30;
constexpr double seconds_for_each = 0.5, least_seconds = 2, most_seconds = 10;  // of playing through

const std::optional<SlowMotion>& asked(const Session& session, Side side) {
  return side_of(session.document(), side).slow_motion;
}

void set_asked(Session& session, Side side, const std::optional<SlowMotion>& motion) {
  if (asked(session, side) == motion) return;
  session.navigate([&](Document& document) { side_of(document, side).slow_motion = motion; });
}

std::uint64_t number_at(double share, std::uint64_t total) {
  return static_cast<std::uint64_t>(std::llround(share * static_cast<double>(total)));
}

bool waits(Session& session) {
  return std::any_of(both_sides.begin(), both_sides.end(), [&](Side side) {
    const RenderState state = session.renderer(side).status().state;
    return asked(session, side) && (state == RenderState::coarse || state == RenderState::full);
  });
}

/// The leading side goes to `at`, the other to the same share of its work.
void go_to(Session& session, std::uint64_t at) {
  const Side lead = slow_lead(session);
  const auto state = slow_state(session, lead);
  if (!state) return;
  at = std::min(at, state->total);
  const double share = state->total == 0 ? 1 : static_cast<double>(at) / static_cast<double>(state->total);
  const Side other = other_side(lead);
  if (const auto beside = slow_state(session, other)) {
    const bool alike = beside->done.unit == state->done.unit && beside->total == state->total;
    set_asked(session, other, SlowMotion{beside->done.unit, alike ? at : number_at(share, beside->total)});
  }
  set_asked(session, lead, SlowMotion{state->done.unit, at});
}

/// A unit that a side's renderer cannot count goes to one that it can.
void follow_settings(Session& session, Side side) {
  const auto& motion = asked(session, side);
  if (!motion) return;
  if (session.file_of(side)) return set_asked(session, side, {});
  if (!slow_motion_lacks(motion->unit, session.settings(side), session.traits())) return;
  const auto unit = first_slow_unit(session.settings(side), session.traits());
  set_asked(session, side, unit ? std::optional(SlowMotion{*unit, all_slow_units}) : std::nullopt);
}

/// A number above what there is becomes the last one. One that was chosen before the number was known becomes the share
/// of the work that the other side has done.
void clamp_number(Session& session, Side side) {
  const auto state = slow_state(session, side);
  if (!state || asked(session, side)->at <= state->total) return;
  std::uint64_t at = state->total;
  const auto beside = slow_state(session, other_side(side));
  if (asked(session, side)->at == all_slow_units && beside && beside->total > 0)
    at = number_at(static_cast<double>(beside->done.at) / static_cast<double>(beside->total), state->total);
  set_asked(session, side, SlowMotion{state->done.unit, at});
}

double seconds_in_all(Session& session) {
  const auto state = slow_state(session, slow_lead(session));
  const double total = state ? static_cast<double>(state->total) : 1;
  return std::clamp(total * seconds_for_each, least_seconds, most_seconds);
}

void advance(Session& session, SlowMotionState& state) {
  if (!state.playing) return;
  const double now = ImGui::GetTime();
  if (now >= state.next_at && !waits(session)) {
    const auto lead = slow_state(session, slow_lead(session));
    if (!lead || lead->done.at >= lead->total) {
      state.playing = false;
      return;
    }
    const double each = static_cast<double>(lead->total) * frame_seconds / seconds_in_all(session);
    go_to(session, lead->done.at + std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(each))));
    state.next_at = now + (each < 1 ? frame_seconds / each : frame_seconds);
  }
  redraw_after(std::max(0.0, state.next_at - now));
}

}  // namespace

bool slow_motion_open(const Session& session) {
  return std::any_of(both_sides.begin(), both_sides.end(), [&](Side side) { return asked(session, side).has_value(); });
}

void toggle_slow_motion(Session& session, SlowMotionState& state) {
  state = {};
  if (slow_motion_open(session)) {
    for (const Side side : both_sides) set_asked(session, side, {});
    return;
  }
  for (const Side side : both_sides)
    if (const auto unit = first_slow_unit(session.settings(side), session.traits()); unit && !session.file_of(side))
      set_asked(session, side, SlowMotion{*unit, all_slow_units});
  if (!slow_motion_open(session))
    session.say(Message::Kind::information,
                std::string("Slow motion: ") +
                    std::string(*slow_motion_lacks(SlowUnit::triangles, session.settings(Side::a), session.traits())) +
                    ".");
}

std::optional<SlowState> slow_state(Session& session, Side side) {
  const auto& motion = asked(session, side);
  const auto result = session.renderer(side).result();
  if (!motion || !result || !result->slow || result->slow->done.unit != motion->unit) return {};
  return result->slow;
}

std::string slow_words(Session& session, Side side) {
  const auto state = slow_state(session, side);
  if (!state) return {};
  const View view = session.view();
  return slow_motion_words(*state, session.scene(), {view.width, view.height});
}

Side slow_lead(const Session& session) {
  const Side picked = session.document().picked;
  return asked(session, picked) ? picked : other_side(picked);
}

double slow_share(Session& session) {
  const auto state = slow_state(session, slow_lead(session));
  if (!state || state->total == 0) return 1;
  const std::uint64_t at = std::min(asked(session, slow_lead(session))->at, state->total);
  return static_cast<double>(at) / static_cast<double>(state->total);
}

void go_to_share(Session& session, double share) {
  if (const auto state = slow_state(session, slow_lead(session))) go_to(session, number_at(share, state->total));
}

void step_slow_motion(Session& session, SlowMotionState& state, std::int64_t by) {
  state.playing = false;
  const auto lead = slow_state(session, slow_lead(session));
  if (!lead) return;
  const std::uint64_t at = std::min(asked(session, slow_lead(session))->at, lead->total);
  const auto back = static_cast<std::uint64_t>(by < 0 ? -by : 0);
  go_to(session, by < 0 ? at - std::min(at, back) : at + static_cast<std::uint64_t>(by));
}

void play_slow_motion(Session& session, SlowMotionState& state) {
  state.playing = !state.playing;
  if (state.playing && slow_share(session) >= 1) go_to_share(session, 0);
  state.next_at = ImGui::GetTime();
}

void update_slow_motion(Session& session, SlowMotionState& state) {
  if (!session.has_scene()) return;
  for (const Side side : both_sides) {
    follow_settings(session, side);
    clamp_number(session, side);
  }
  // While the scrubber moves, each picture is finished before the next begins: so something moves at any speed.
  if (state.wanted && (!state.held || !waits(session))) {
    go_to_share(session, *state.wanted);
    state.wanted.reset();
  }
  if (state.wanted) redraw_after(frame_seconds);
  advance(session, state);
}

void add_slow_motion_actions(Actions& actions, Session& session, SlowMotionState& state,
                             std::function<bool()> letters_free) {
  actions.add(
      {.name = "slow-motion",
       .label = "Slow motion: pictures as they are drawn",
       .group = "Slow motion",
       .keys = "S",
       .run = [&session, &state] { toggle_slow_motion(session, state); },
       .enabled = [&session, letters_free = std::move(letters_free)] { return session.has_scene() && letters_free(); },
       .checked = [&session] { return slow_motion_open(session); }});
  const auto open = [&session] { return slow_motion_open(session); };
  // A presenter's remote control blanks the screen with the full stop.
  const auto open_before_class = [&session] {
    return slow_motion_open(session) && session.document().mode != ScreenMode::presenter;
  };
  actions.add({.name = "slow-play",
               .label = "Play or pause slow motion",
               .group = "Slow motion",
               .borrowed_keys = "Space",
               .run = [&session, &state] { play_slow_motion(session, state); },
               .enabled = open,
               .checked = [&state] { return state.playing; }});
  const auto step = [&](const char* name, const char* label, const char* keys, std::int64_t by) {
    actions.add({.name = name,
                 .label = label,
                 .group = "Slow motion",
                 .borrowed_keys = keys,
                 .kind = ActionKind::repeat,
                 .run = [&session, &state, by] { step_slow_motion(session, state, by); },
                 .enabled = open_before_class});
  };
  step("slow-back", "Slow motion: one back", ",", -1);
  step("slow-forward", "Slow motion: one on", ".", 1);
}

void offer_slow_motion_values(Session& session, SlowMotionState& state) {
  Values& out = values();
  for (const Side side : both_sides) {
    const std::string name = side == Side::a ? "slow/a/" : "slow/b/";
    out.offer(name + "asked", [&session, side] {
      const auto& motion = asked(session, side);
      return motion ? slow_motion_text(*motion) : std::string("whole");
    });
    out.offer(name + "words", [&session, side] { return slow_words(session, side); });
    out.offer(name + "total", [&session, side] {
      const auto now = slow_state(session, side);
      return now ? now->total : std::uint64_t{0};
    });
  }
  out.offer("slow/open", [&session] { return slow_motion_open(session); });
  out.offer("slow/playing", [&state] { return state.playing; });
}

}  // namespace ps::gui
