#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/panels/panel.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/work/background_study.h"
#include "study/unsafe_settings.h"

namespace ps::gui {

using UnsafeStudy = BackgroundStudy<std::vector<UnsafeSetting>>;

/// What is known of one side's settings.
struct UnsafeSide {
  explicit UnsafeSide(const std::function<void()>& wake) : study(wake) {}
  bool asked = false;
  Settings settings;  ///< those that were asked about, in this scene and view
  SceneRevision revision;
  View view;
  std::vector<UnsafeSetting> known;  ///< leaves a safe window; shares are measured only if `measured`
  bool measured = false;
  UnsafeStudy study;
};

/// Watches the settings of both sides: one calm line below a picture whose settings fail somewhere in it, which leads
/// to the experiment that explains why.
class UnsafeLines final : public Panel {
 public:
  UnsafeLines(const PanelHost& host, const PicturesState& pictures)
      : Panel(host, {.name = "unsafe", .place = PanelPlace::over}),
        pictures_(pictures), sides_{UnsafeSide(host.wake), UnsafeSide(host.wake)} {}
  bool draw(const Context& context) override;
  void offer(Values& out) override;
  /// Asks anew where settings, scene or view have changed.
  void update() override;
  bool busy() const override { return sides_[0].study.running() || sides_[1].study.running(); }

 private:
  const PicturesState& pictures_;
  std::array<UnsafeSide, 2> sides_;
};

}  // namespace ps::gui
