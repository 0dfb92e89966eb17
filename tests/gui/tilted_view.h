#pragma once
#include "frame/view.h"

namespace ps::gui {

/// A view through a camera that is turned about the y axis and away from the origin.
inline View tilted_view() {
  View view;
  view.width = 320;
  view.height = 200;
  view.camera.position = {1, -2, 0.5};
  view.camera.right = {0.8, 0, -0.6};
  view.camera.forward = {0.6, 0, 0.8};
  view.camera.projection_plane_d = 1.5;
  return view;
}

}  // namespace ps::gui
