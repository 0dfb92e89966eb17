#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/base/values.h"
#include "gui/panels/studies/chart_plot.h"
#include "gui/panels/studies/chart_setup.h"
#include "gui/panels/studies/chart_study.h"
#include "gui/panels/studies/layout_choice.h"
#include "gui/panels/studies/seen_estimate.h"
#include "gui/panels/studies/study_folder.h"
#include "gui/platform/texture.h"

namespace ps::gui {

/// The small pictures of the point under the mouse.
struct ChartPreview {
  std::shared_ptr<const Image<Rgb8>> of, against;  ///< what the textures were made from
  Texture picture, difference;
  double gain = 1;  ///< of the difference
};

/// State of the chart.
struct ChartTabState {
  explicit ChartTabState(const std::function<void()>& wake) : study(wake), estimate(wake) {}

  ChartSetup setup;
  bool begun = false;  ///< the first sweep has been chosen
  LayoutChoice sweep{&Layout::sweep};
  ErrorMetric metric = ErrorMetric::rmse;
  ChartAcross across = ChartAcross::time;
  ChartPlan plan;
  bool kept = false;                        ///< results of the plan lie in its folder
  std::string kept_for;                     ///< key of the plan that `kept` was found for
  std::string measured;                     ///< key of the plan whose results are shown
  std::shared_ptr<const ChartFound> found;  ///< what `chart` was made from
  Chart chart;                              ///< in the metric and along the axis that are chosen
  std::string conclusion;                   ///< what `chart` shows, in a sentence
  ChartLabels labels;
  std::optional<std::size_t> hovered;
  ChartPreview preview;

  std::vector<std::string> idle_sweeps;  ///< why a named sweep changes nothing here, one for each; empty if it does
  std::string idle_for;                  ///< key of the plan that they were found for
  std::string estimated;                 ///< key of the plan and its runs that `estimate` was begun for
  Seen seen;

  ChartStudy study;
  ChartEstimateStudy estimate;  ///< of what Measure will take
};

/// What the chart asks of the window around it.
struct ChartHost {
  std::function<void()> browse_reference;                         ///< ask for a picture file
  std::function<void(const std::string& suggestion)> ask_export;  ///< ask where to write
  std::function<void(const std::string& text)> copy;              ///< put text on the clipboard
};

/// Takes up what the study has found; once per frame, also while the tab is not open.
void update_chart(Session& session, ChartTabState& state);
/// Time or work against error over a sweep. `filled`: it has the whole window; answers whether that shall change.
bool chart_tab(Session& session, ChartTabState& state, const StudyFolder& folder, const ChartHost& host, bool filled);
/// Sweeps one option alone, as its context menu asks.
void sweep_option(ChartTabState& state, const Option& option, Side side);
/// Begins, or goes on with, what is planned.
void measure_chart(Session& session, ChartTabState& state, const StudyFolder& folder);
/// Writes the chart as the extension asks: .csv, .json or .svg. Throws InputError.
void export_chart(const ChartTabState& state, const std::filesystem::path& path);
/// What scripts may ask for. The state must outlive the offers.
void offer_chart_values(Values& out, const ChartTabState& state);

}  // namespace ps::gui
