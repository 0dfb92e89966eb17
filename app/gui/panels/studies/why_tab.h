#pragma once
#include <array>

#include "gui/panels/studies/study.h"
#include "gui/platform/texture.h"
#include "study/difference_by_cause.h"
#include "study/precision_map.h"

namespace ps::gui {

/// Which option is to blame for how much of the difference between A and B.
struct CausesTab : Study<DifferenceByCause> {
  explicit CausesTab(const PanelHost& host);
  void measure(Session& session) override;

 protected:
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  std::string reason_against(Session& session) const override;
  void offer_found(Values& out) const override;

 private:
  std::array<Settings, 2> compared_;  ///< the settings that the causes are about
};

/// What one side's arithmetic gets wrong, with what it was measured for.
struct PrecisionFound {
  Side side = Side::a;
  std::string scene_name;
  PrecisionMap map;
  Image<Rgb8> faults, gaps;  ///< pictures of the map
};

/// What float gets wrong in a picture.
struct PrecisionTab : Study<PrecisionFound> {
  explicit PrecisionTab(const PanelHost& host);
  void measure(Session& session) override;

 protected:
  void choices(Session& session) override;
  void draw_result(Session& session) override;
  std::string about(const Session& session) const override;
  void took(Session& session) override;
  void offer_found(Values& out) const override;

 private:
  Side side_ = Side::a;
  std::array<Texture, 2> textures_;  ///< faults, gaps
};

/// Both, one of them shown.
class WhyTab final : public Panel {
 public:
  explicit WhyTab(const PanelHost& host);
  bool draw(const Context& context) override;
  void offer(Values& out) override;
  void update() override;
  bool busy() const override { return causes_.busy() || precision_.busy(); }
  std::string status() const override;

 private:
  CausesTab causes_;
  PrecisionTab precision_;
  enum class Shown { causes, precision } shown_ = Shown::causes;
};

}  // namespace ps::gui
