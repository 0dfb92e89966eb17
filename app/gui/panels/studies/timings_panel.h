#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>

#include "gui/base/values.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"
#include "study/pair_timing.h"

namespace ps::gui {

/// Times of both pictures, with what was timed.
struct FoundTiming {
  std::array<PictureRequest, 2> requests;
  PairTiming timing;
};

/// State of the tab.
struct TimingsState {
  explicit TimingsState(const std::function<void()>& wake) : study(wake) {}
  BackgroundStudy<FoundTiming> study;
  std::shared_ptr<const FoundTiming> found;  ///< the newest
};

/// Stage times and counters of A and B side by side. Times of both by turns on a button, with their ratio; before,
/// those of the single runs.
void timings_panel(Session& session, TimingsState& state);
/// Takes up what has been timed, and stops when the pictures have become others.
void update_timings(Session& session, TimingsState& state);
/// What scripts may ask for.
void offer_timings_values(Values& out, const TimingsState& state);

/// "B takes 4.6 times as long as A (4.4 to 4.9; 9 rounds).", or that there is no order within noise.
std::string ratio_sentence(const PairTiming& timing);

}  // namespace ps::gui
