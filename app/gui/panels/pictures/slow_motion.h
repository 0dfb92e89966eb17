#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "gui/input/actions.h"
#include "gui/session/session.h"

namespace ps::gui {

/// State of slow motion. How far the pictures are drawn is in the document.
struct SlowMotionState {
  bool playing = false;
  double next_at = 0;            ///< seconds on the window's clock when playing goes on
  std::optional<double> wanted;  ///< share of the work, 0 to 1, that waits for the pictures before it
  bool held = false;             ///< the scrubber is being dragged
};

/// A number above any there is: all of them, which is how the document has it until they are known.
inline constexpr std::uint64_t all_slow_units = 1'000'000'000'000;

/// Is a picture shown before it is finished?
bool slow_motion_open(const Session& session);
/// Opens it with both pictures whole, or shows the finished pictures again.
void toggle_slow_motion(Session& session, SlowMotionState& state);

/// How far a side has come, as its newest picture says; nullopt while none has come, or where the side shows all.
std::optional<SlowState> slow_state(Session& session, Side side);
/// The same in words: "triangle 17 of 1,284: triangle 5 of teapot"; empty where there is none.
std::string slow_words(Session& session, Side side);
/// The side that steps count in: the picked one, or the other where that shows all.
Side slow_lead(const Session& session);
/// How much of its work the leading side has done, 0 to 1.
double slow_share(Session& session);

/// Both sides go to the same share of their work; where they count the same, to the same number.
void go_to_share(Session& session, double share);
/// The leading side goes on by `by` of its units, the other with it.
void step_slow_motion(Session& session, SlowMotionState& state, std::int64_t by);
void play_slow_motion(Session& session, SlowMotionState& state);

/// Once a frame: what waits for pictures, playing, units that the renderer has no longer.
void update_slow_motion(Session& session, SlowMotionState& state);

/// `letters_free`: letters are commands now, and do not move the camera.
void add_slow_motion_actions(Actions& actions, Session& session, SlowMotionState& state,
                             std::function<bool()> letters_free);
/// Values for scripts.
void offer_slow_motion_values(Session& session, SlowMotionState& state);

}  // namespace ps::gui
