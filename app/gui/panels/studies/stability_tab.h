#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gui/base/values.h"
#include "gui/panels/studies/curve_plot.h"
#include "gui/panels/studies/film_strip_view.h"
#include "gui/panels/studies/layout_choice.h"
#include "gui/panels/studies/stability_opening.h"
#include "gui/panels/studies/step_work.h"
#include "gui/session/session.h"
#include "gui/work/background_study.h"
#include "study/stability_study.h"

namespace ps::gui {

/// What the study that was started last has measured so far, and what it found on disk.
struct StabilityFound {
  std::map<std::string, MeasuredExperiment, std::less<>> measured;  ///< by key
  std::string now;                                                  ///< key of the one that is being measured
};
using StabilityStudy = BackgroundStudy<StabilityFound>;

/// State of the laboratory.
struct StabilityTabState {
  explicit StabilityTabState(const std::function<void()>& wake) : strip(wake), study(wake), opening(wake) {}

  std::string selected;  ///< key of the experiment that is shown; empty = the first
  LayoutChoice choice{&Layout::experiment};
  std::string search;  ///< in the list
  std::string series;  ///< name of its figure, as chosen; empty = the first
  std::map<std::string, MeasuredExperiment, std::less<>> measured;  ///< by key; one of them may be a part
  std::map<std::string, std::string, std::less<>> worst;            ///< what the list says of complete experiments
  std::vector<std::string> asked;                                   ///< keys of the study that was started last
  StepWork of_step;                                                 ///< the study, where it was not asked for
  std::shared_ptr<const StabilityFound> taken;                      ///< what was taken up last
  std::shared_ptr<const StabilityOpening> opened;                   ///< the point that was shown last
  std::filesystem::path folder;                                     ///< where results are kept as they arrive
  bool looked = false;                                              ///< into that folder
  FilmStripState strip;

  StabilityStudy study;
  StabilityOpeningStudy opening;
};

/// Experiments where methods fail, naive beside robust. `filled`: it has the whole window; answers whether that shall
/// change.
bool stability_tab(Session& session, StabilityTabState& state, bool filled);
/// Takes up what has been measured; once per frame. `folder` is for scenes of points that are
/// opened.
void update_stability(Session& session, StabilityTabState& state, const std::filesystem::path& folder);
/// Shows an experiment by its key, and measures it unless that was done.
void show_experiment(StabilityTabState& state, const std::string& key);
/// Something is being measured, rendered or opened.
bool stability_busy(const StabilityTabState& state);
/// What scripts may ask for. The state must outlive the offers.
void offer_stability_values(Values& out, const StabilityTabState& state);

}  // namespace ps::gui
