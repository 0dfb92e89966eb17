#pragma once
#include "scene/camera.h"

namespace ps {

/// The view: a camera and the size of the picture in pixels.
struct View {
  Camera camera;
  int width = 600;
  int height = 600;
  bool operator==(const View&) const = default;
};

}  // namespace ps
