#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gui/panels/studies/curve_plot.h"
#include "gui/panels/studies/film_strip_view.h"
#include "gui/panels/studies/layout_choice.h"
#include "gui/panels/studies/stability_opening.h"
#include "gui/panels/studies/step_work.h"
#include "gui/panels/studies/study.h"
#include "gui/panels/studies/study_folder.h"
#include "study/stability/figures.h"
#include "study/stability_study.h"

namespace ps::gui {

/// What the study that was started last has measured so far.
struct StabilityFound {
  std::map<std::string, MeasuredExperiment, std::less<>> measured;  ///< by key
  std::string now;                                                  ///< key of the one that is being measured
};

/// The laboratory: experiments where methods fail, naive beside robust.
struct StabilityTab : Study<StabilityFound> {
  /// Results are kept in `folder` as they arrive, and scenes of points that are opened.
  StabilityTab(const PanelHost& host, const StudyFolder& folder);

  void add_actions(Actions& actions) override;
  void take(const PanelMessage& message) override;
  /// Measures the experiment that is shown again, or goes on with what is left.
  void measure(Session& session) override;
  bool busy() const override;
  std::string status() const override;

 protected:
  bool has_subject(const Session&) const override { return true; }
  void follow(Session& session) override;
  void choices(Session& session) override;
  void more_controls(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  bool says_stopped() const override { return !left_over().empty(); }
  std::string measure_word() const override;
  void take_up(Session& session) override;
  void took(Session& session) override;
  void offer_found(Values& out) const override;

 private:
  using Figures = std::vector<ExperimentFigure>;

  /// Shows an experiment by its key, and measures it unless that was done. Throws InputError.
  void show(const std::string& key);
  const StabilityExperiment& selected() const;
  const MeasuredExperiment* result_of(std::string_view key) const;
  bool complete(std::string_view key) const;
  std::string why_absent(std::string_view key) const;
  void look_into_folder();
  bool is_awaited() const { return work.running() && !of_step_.left(); }
  void begin(std::vector<std::string> keys, StabilityRequest::Kept kept);
  void select(const StabilityExperiment& experiment);
  std::vector<std::string> left_over() const;
  std::size_t complete_count() const;
  std::optional<std::string> value(std::string_view name) const;

  // --- what it draws ---
  std::string note_of(const StabilityExperiment& experiment);
  void list_row(const StabilityExperiment& experiment);
  void list();
  void experiment_choice();
  std::size_t shown_figure(const Figures& figures) const;
  void figure_choice(const Figures& figures);
  const char* no_figure_text(const StabilityExperiment& experiment) const;
  std::optional<PlotFrame> curve_area(const StabilityExperiment& experiment, const ExperimentFigure& figure,
                                      const Area& area, ImVec2 mouse, bool clicked);
  std::optional<PlotFrame> figure_area(const StabilityExperiment& experiment, const Figures& figures, float height);
  void option_switch(Session& session, const StabilityExperiment& experiment);
  void shown_experiment(Session& session);

  std::filesystem::path results_, scenes_;
  std::string selected_;  ///< key of the experiment that is shown; empty = the first
  LayoutChoice choice_{&Layout::experiment};
  std::string search_;  ///< in the list
  std::string series_;  ///< name of its figure, as chosen; empty = the first
  std::map<std::string, MeasuredExperiment, std::less<>> measured_;  ///< by key; one of them may be a part
  std::map<std::string, std::string, std::less<>> worst_;            ///< what the list says of complete experiments
  std::vector<std::string> asked_;                                   ///< keys of the study that was started last
  StepWork of_step_;                                                 ///< the study, where it was not asked for
  std::shared_ptr<const StabilityOpening> opened_;                   ///< the point that was shown last
  bool looked_ = false;                                              ///< into the folder of results
  FilmStripState strip_;
  StabilityOpeningStudy opening_;
};

}  // namespace ps::gui
