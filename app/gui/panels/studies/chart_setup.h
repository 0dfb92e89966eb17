#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gui/panels/panel.h"
#include "study/chart.h"

namespace ps::gui {

/// Where a chart's pictures are compared.
enum class ChartPart { whole, rectangle };

/// Subject of a sweep: options, or the model from full to reduced.
enum class Swept { options, model };

/// The measurement that the user has asked for.
struct ChartSetup {
  Swept swept = Swept::options;
  std::vector<SweepAxis> axes;
  std::vector<std::string> typed;  ///< for each axis its values as they are in the field, "0,1,2"
  Side side = Side::a;             ///< whose settings are under the sweep
  ErrorValues values = ErrorValues::display;
  ChartPart part = ChartPart::whole;
  MachineryRule machinery = MachineryRule::same;
  int repeats = 5;
  int reference_samples = 0;   ///< a square number; 0 = as the truth of the swept options asks (plan_reference)
  std::string reference_file;  ///< empty = one is rendered
  std::string search;          ///< for an option to add
};

/// Sweeps these options.
void set_axes(ChartSetup& setup, std::vector<SweepAxis> axes);

/// The plan of a setup for the open scene. Made anew only when something of it changes.
struct ChartPlan {
  std::string key;                  ///< everything that decides the results, as text
  std::vector<SweepPoint> points;   ///< empty if there is an error, and for the model, which is weighed first
  std::vector<std::string> notes;   ///< swept options without effect here, and what is absent
  std::vector<std::string> absent;  ///< Chart::absent
  std::string truth;                ///< what errors are measured against
  std::string error;                ///< why it cannot be measured
  Settings base;                    ///< what is under the sweep
};
/// While the settings change in swept options alone, as when a point is loaded, the plan stays.
void update_plan(ChartPlan& plan, const ChartSetup& setup, const Session& session);

/// The request without its folder. The plan must be free of errors.
ChartRequest make_request(const ChartPlan& plan, const ChartSetup& setup, ErrorMetric metric, const Session& session);

/// The command that measures the same without a window.
std::string command_of(const ChartPlan& plan, const ChartSetup& setup, ErrorMetric metric, const Session& session);

/// The model's sweep, or that of the options: Layout::sweep.
std::string swept_text(const ChartSetup& setup);

/// The controls for all of it but the named sweeps.
void chart_setup_controls(ChartSetup& setup, const ChartPlan& plan, const Session& session, const PanelHost& host);

}  // namespace ps::gui
