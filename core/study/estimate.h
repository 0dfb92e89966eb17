#pragma once
#include "study/chart.h"
#include "study/needs.h"

namespace ps {

struct ModelRequest;

/// What a study will take, before it starts.
struct StudyEstimate {
  int pictures = 0;    ///< that are rendered for people to see: points of a chart, or pictures tried
  double seconds = 0;  ///< wall time on this machine, as busy as it was while the estimate was made
};

/// Renders each picture of the chart, and its reference, small (an eighth and a quarter as wide), and concludes from
/// their times how long the study will take: a fixed part and one that grows with the number of pixels. Takes a few
/// hundredths of the study. Throws Cancelled and InputError.
StudyEstimate estimate_chart(const ChartRequest& request, StudyControl& control, const Clock& clock = steady_seconds);

/// The least that the search takes: every feature is left out once, every saving is tried once, and times are measured.
/// Each saving that is taken adds a round of at most as many pictures as there are savings. Made as estimate_chart().
struct NeedsEstimate {
  StudyEstimate least;
  StudyEstimate round;  ///< of trying every saving once more
};
NeedsEstimate estimate_needs(const NeedsRequest& request, StudyControl& control, const Clock& clock = steady_seconds);

/// The least that find_model_needs() takes: the full pictures, what they show, and the first steps that are tried. Made
/// as estimate_chart().
StudyEstimate estimate_model(const ModelRequest& request, StudyControl& control, const Clock& clock = steady_seconds);

/// "about 40 s", "about 3 min", "under a second".
std::string about_seconds(double seconds);
/// "at least about 40 s"; below a second "about a second".
std::string at_least(double seconds);
/// "about 40 s, 20 pictures"
std::string estimate_text(const StudyEstimate& estimate);

}  // namespace ps
