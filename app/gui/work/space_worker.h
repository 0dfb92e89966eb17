#pragma once
#include <functional>

#include "gui/work/latest_result.h"
#include "inspect/space_picture.h"

namespace ps::gui {

/// The scene from outside.
struct SpaceRequest {
  Scene scene;
  View view;        ///< of the viewer, not of the picture
  double near = 1;  ///< nothing nearer is drawn, world units
};

/// Draws the scene from outside in the background.
class SpaceWorker : public LatestResult<SpaceRequest, SpacePicture> {
 public:
  explicit SpaceWorker(std::function<void()> wake);
};

}  // namespace ps::gui
