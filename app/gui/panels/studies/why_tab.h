#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>

#include "gui/base/values.h"
#include "gui/platform/texture.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"
#include "study/difference_by_cause.h"
#include "study/precision_map.h"

namespace ps::gui {

/// What one side's arithmetic gets wrong, with what it was measured for.
struct PrecisionFound {
  Side side = Side::a;
  std::string scene_name;
  PrecisionMap map;
  Image<Rgb8> faults, gaps;  ///< pictures of the map
};
using CausesStudy = BackgroundStudy<DifferenceByCause>;
using PrecisionStudy = BackgroundStudy<PrecisionFound>;

/// State of the tab.
struct WhyTabState {
  explicit WhyTabState(const std::function<void()>& wake) : causes(wake), precision(wake) {}

  enum class Shown { causes, precision } shown = Shown::causes;
  Side side = Side::a;                                  ///< whose precision is looked at
  std::array<Settings, 2> compared;                     ///< the settings that the causes are about
  std::shared_ptr<const DifferenceByCause> difference;  ///< the newest
  std::shared_ptr<const PrecisionFound> map;            ///< what the textures were made from
  std::array<Texture, 2> textures;                      ///< faults, gaps

  CausesStudy causes;
  PrecisionStudy precision;

  bool running() const { return causes.running() || precision.running(); }
};

/// Why the pictures differ: which option is to blame for how much, and what float gets wrong. `filled`: it has the
/// whole window; answers whether that shall change.
bool why_tab(Session& session, WhyTabState& state, bool filled);
void update_why(WhyTabState& state);
/// What it is working at, for the line at the lower edge.
std::string why_status(const WhyTabState& state);
/// What scripts may ask for. The state must outlive the offers.
void offer_why_values(Values& out, const WhyTabState& state);

/// "wrong-winner": how scripts name a fault.
std::string fault_key(PrecisionFault fault);

// --- the views ---
void causes_view(const Session& session, const WhyTabState& state);
void precision_view(Session& session, WhyTabState& state);

}  // namespace ps::gui
