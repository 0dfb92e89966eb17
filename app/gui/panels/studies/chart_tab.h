#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/panels/studies/chart_plot.h"
#include "gui/panels/studies/chart_setup.h"
#include "gui/panels/studies/layout_choice.h"
#include "gui/panels/studies/study.h"
#include "gui/panels/studies/study_folder.h"
#include "gui/panels/studies/table_cells.h"
#include "gui/platform/texture.h"

namespace ps::gui {

/// A chart as far as it is measured. The points' pictures are shared among the states of one chart.
struct ChartFound {
  Chart chart;                                                 ///< its points without pictures
  std::map<int, std::shared_ptr<const Image<Rgb8>>> pictures;  ///< by the number of the point
  std::shared_ptr<const Image<Rgb8>> reference;                ///< what they are compared with
};

/// Measures a chart, or goes on with it; its results are kept in the request's folder. `report` is called for each new
/// state. Throws Cancelled and InputError.
void run_chart_study(const ChartRequest& request, StudyControl& control,
                     const std::function<void(const StudyStatus&, std::shared_ptr<const ChartFound>)>& report);

/// The small pictures of the point under the mouse.
struct ChartPreview {
  std::shared_ptr<const Image<Rgb8>> of, against;  ///< what the textures were made from
  Texture picture, difference;
  double gain = 1;  ///< of the difference
};

/// Time or work against error over a sweep.
struct ChartTab : EstimatedStudy<ChartFound> {
  /// `results`: where they are kept from one start to the next; must outlive the tab.
  ChartTab(const PanelHost& host, const StudyFolder& results);

  ChartSetup setup;
  ChartPlan plan;
  ErrorMetric metric = ErrorMetric::rmse;
  ChartAcross across = ChartAcross::time;
  Chart chart;  ///< what was found, in the metric and along the axis that are chosen
  ChartPreview preview;
  SmallPictures strip;  ///< the points' pictures under the plot

  void measure(Session& session) override;
  void take(const PanelMessage& message) override;
  bool measures_times() const override { return measuring(); }

 protected:
  void follow(Session& session) override;
  void choices(Session& session) override;
  void more_controls(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  std::string measure_word() const override;
  std::string reason_against(Session&) const override { return plan.error; }
  void keep_estimate(Session& session) override;
  std::string expected() const override;
  void took(Session&) override { show_found(); }
  void offer_found(Values& out) const override;

 private:
  void begin();
  void show_found();
  bool of_plan() const { return found && measured_ == plan.key; }
  void sweep_choice();
  void setup_popup(Session& session);
  void metric_choice(float width);
  void across_choice(float width);
  void ask_export(const std::string& suggestion);
  /// Writes the chart as the extension asks: .csv, .json or .svg. Throws InputError.
  void write(const std::filesystem::path& path) const;
  void export_menu(const Session& session);
  void load_on_click(Session& session, bool clicked);

  const StudyFolder& results_;
  bool begun_ = false;  ///< the first sweep has been chosen
  LayoutChoice sweep_{&Layout::sweep};
  bool kept_ = false;       ///< results of the plan lie in its folder
  std::string kept_for_;    ///< key of the plan that `kept_` was found for
  std::string measured_;    ///< key of the plan whose results are shown
  std::string conclusion_;  ///< what `chart` shows, in a sentence
  ChartLabels labels_;
  std::optional<std::size_t> hovered_;
  std::vector<std::string> idle_sweeps_;  ///< why a named sweep changes nothing here, one for each; empty if it does
};

}  // namespace ps::gui
