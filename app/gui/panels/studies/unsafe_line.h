#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/base/values.h"
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

/// Watches the settings of both sides.
struct UnsafeState {
  explicit UnsafeState(const std::function<void()>& wake) : sides{UnsafeSide(wake), UnsafeSide(wake)} {}
  std::array<UnsafeSide, 2> sides;
};

/// Once per frame: asks anew where settings, scene or view have changed.
void update_unsafe(Session& session, UnsafeState& state);
/// One calm line below a picture whose settings fail somewhere in it. Returns the experiment that explains why, when
/// the user asks for it.
std::optional<std::string> unsafe_lines(Session& session, UnsafeState& state, const PicturesState& pictures);
/// What scripts may ask for. The state must outlive the offers.
void offer_unsafe_values(Values& out, const UnsafeState& state);

}  // namespace ps::gui
