#pragma once
#include "frame/view.h"
#include "scene/scene.h"

namespace ps::bench {

struct FillScene {
  Scene scene;
  View view;
};

/// Two triangles that fill the picture, with a smooth texture (1024 x 1024, repeated 4 times across) or without. On
/// 1920 pixels 2.1 texels fall on a pixel's width, so that trilinear filtering reads two levels.
FillScene fill_scene(int width, int height, bool textured);

}  // namespace ps::bench
