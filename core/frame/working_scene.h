#pragma once
#include <optional>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/working_space.h"

namespace ps {

/// A scene, with what a picture of it needs, as a renderer gets it: in its working space, where `camera-relative` is on
/// and the renderer computes in float; else as it is. What is made for it is cached in Prepared, and stays while the
/// camera moves. `scene`, `view` and `settings` are references to the ones given, which must stay, or to copies held
/// here.
class WorkingScene {
 public:
  WorkingScene(const Scene& given_scene, const View& given_view, const Settings& given_settings, Prepared& prepared);
  WorkingScene(const WorkingScene&) = delete;
  WorkingScene& operator=(const WorkingScene&) = delete;

  const WorkingSpace space;
  const Scene& scene() const { return held_ ? held_->scene : scene_; }
  const View& view() const { return held_ ? held_->view : view_; }
  const Settings& settings() const { return held_ ? held_->settings : settings_; }
  /// Brings the lengths in a picture of it back to world units.
  void to_world(Frame& frame) const;

 private:
  struct Held {
    Scene scene;
    View view;
    Settings settings;
  };
  const Scene& scene_;
  const View& view_;
  const Settings& settings_;
  std::optional<Held> held_;
};

}  // namespace ps
