#pragma once
#include <functional>
#include <memory>

#include "gui/base/values.h"
#include "gui/panels/studies/needs_view.h"
#include "gui/panels/studies/seen_estimate.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"
#include "study/estimate.h"
#include "study/needs.h"

namespace ps::gui {

using NeedsStudy = BackgroundStudy<Needs>;
using NeedsEstimateStudy = BackgroundStudy<NeedsEstimate>;

/// State of the advice.
struct NeedsTabState {
  explicit NeedsTabState(const std::function<void()>& wake) : study(wake), estimate(wake) {}

  Side side = Side::a;
  double tolerance = NeedsRequest{}.tolerance;
  bool trail_open = true;
  Side measured_side = Side::a;        ///< whose settings the advice is about
  Settings base;                       ///< those settings
  std::string scene_name;              ///< the scene they were measured with
  std::shared_ptr<const Needs> needs;  ///< as far as it is known
  NeedsThumbnails thumbnails;
  std::string estimated;  ///< what `estimate` was begun for
  Seen seen;

  NeedsStudy study;
  NeedsEstimateStudy estimate;  ///< of what the search will take at least
};

/// Each feature's share of picture and cost, and the cheapest settings within a tolerance. `filled`: it has the whole
/// window; answers whether that shall change.
bool needs_tab(Session& session, NeedsTabState& state, bool filled);
/// Takes up what has been found; once per frame.
void update_needs(NeedsTabState& state);
/// What scripts may ask for. The state must outlive the offers.
void offer_needs_values(Values& out, const NeedsTabState& state);

}  // namespace ps::gui
