#pragma once
#include "gui/panels/studies/model_tab.h"
#include "gui/panels/studies/needs_view.h"
#include "gui/panels/studies/study.h"
#include "study/needs.h"

namespace ps::gui {

/// Each feature's share of picture and cost, and the cheapest settings within a tolerance.
struct OptionNeeds : EstimatedStudy<Needs, NeedsEstimate> {
  explicit OptionNeeds(const PanelHost& host);
  void measure(Session& session) override;
  bool measures_times() const override { return measuring(); }

 protected:
  void choices(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  void keep_estimate(Session& session) override;
  std::string expected() const override;
  void offer_found(Values& out) const override;

 private:
  void invitation() const;
  void advice(Session& session) const;
  std::optional<std::string> value(std::string_view name) const;

  Side side_ = Side::a;
  double tolerance_ = NeedsRequest{}.tolerance;
  bool trail_open_ = true;
  Side measured_side_ = Side::a;  ///< whose settings the advice is about
  Settings base_;                 ///< those settings
  std::string scene_name_;        ///< the scene they were measured with
  SmallPictures thumbnails_;
};

/// The needs of the scene: of its options, and of its model.
class NeedsTab final : public StudyParts {
 public:
  /// `results`: where scenes that are applied lie; must outlive the tab.
  NeedsTab(const PanelHost& host, const StudyFolder& results);

 private:
  OptionNeeds options_;
  ModelTab model_;
};

}  // namespace ps::gui
