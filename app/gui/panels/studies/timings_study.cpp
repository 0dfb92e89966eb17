// Timing both pictures in the background.
#include <fmt/format.h>

#include "gui/base/values.h"
#include "gui/panels/studies/timings_panel.h"

namespace ps::gui {

void update_timings(Session& session, TimingsState& state) {
  const auto found = state.study.found();
  if (found && found != state.found) {
    state.found = found;
    for (std::size_t side = 0; side < 2; ++side)
      session.timed().add({found->requests[side], found->timing.time_ms[side], found->timing.rounds()});
  }
  if (!state.study.running() || !session.has_scene()) return;
  for (const Side side : both_sides) {
    const auto status = session.renderer(side).status();
    if (status.state != RenderState::done) return state.study.cancel();
  }
}

void offer_timings_values(Values& out, const TimingsState& state) {
  out.offer("timings/running", [&state] { return state.study.running(); });
  out.offer("timings/rounds", [&state] { return state.found ? state.found->timing.rounds() : 0; });
}

std::string ratio_sentence(const PairTiming& timing) {
  const Quartiles& ratio = timing.ratio;
  if (!timing.shows_an_order())
    return fmt::format("{}: B / A is {:.2g} ({:.2g} to {:.2g}; {} rounds).",
                       timing.equal_settings ? "The options of A and B are equal, and times differ by noise alone"
                                             : "The times of A and B are equal within noise",
                       ratio.median, ratio.q1, ratio.q3, timing.rounds());
  const bool b_longer = ratio.median > 1;
  const double factor = b_longer ? ratio.median : 1 / ratio.median, low = b_longer ? ratio.q1 : 1 / ratio.q3,
               high = b_longer ? ratio.q3 : 1 / ratio.q1;
  return fmt::format("{} takes {:.2g} times as long as {} ({:.2g} to {:.2g}; {} rounds).", b_longer ? 'B' : 'A', factor,
                     b_longer ? 'A' : 'B', low, high, timing.rounds());
}

}  // namespace ps::gui
