#pragma once
#include "gui/panels/studies/study.h"
#include "gui/panels/studies/study_folder.h"
#include "study/model/model_needs.h"

namespace ps::gui {

/// The parts of the scene's model that no picture would miss, and the scene without them.
struct ModelTab : EstimatedStudy<ModelNeeds> {
  /// `results`: where scenes that are applied lie; must outlive the tab.
  ModelTab(const PanelHost& host, const StudyFolder& results);
  void measure(Session& session) override;

 protected:
  void choices(Session& session) override;
  void more_controls(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  void keep_estimate(Session& session) override;
  std::string expected() const override;
  void offer_found(Values& out) const override;

 private:
  enum class Views { one, around };
  ModelRequest request_for(const Session& session) const;
  void use(Session& session);
  void ask_file();
  std::optional<std::string> value(std::string_view name) const;

  const StudyFolder& results_;
  Side side_ = Side::a;
  double tolerance_ = ModelRequest{}.tolerance;
  Views views_ = Views::one;
  ModelRequest measured_;   ///< what the result is about; its scene is the full one
  std::string scene_name_;  ///< of that scene
  std::string key_;         ///< picture_key() of it
  Side measured_side_ = Side::a;
};

}  // namespace ps::gui
