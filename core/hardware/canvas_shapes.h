#pragma once
#include <vector>

#include "hardware/picture_plan.h"
#include "math/vec.h"
#include "scene/canvas_item.h"

namespace ps::hardware {

/// A vertex as canvas_vertex.glsl reads it.
struct CanvasCorner {
  Vec2f place{0, 0};  ///< pixels from the top left
  Vec3f colour{0, 0, 0};
};

/// Vertices that are drawn by one call.
struct CanvasDraw {
  bool lines = false;  ///< pairs of vertices; otherwise triangles, three by three
  Blend blend = Blend::replace;
  std::size_t first = 0, count = 0;
};

/// The shapes of the scene's canvas, in the order of the scene.
struct CanvasShapes {
  std::vector<CanvasCorner> corners;
  std::vector<CanvasDraw> draws;
};

/// `subpixel_bits` are the driver's: positions are rounded to them where the processor snaps vertices.
CanvasShapes canvas_shapes(const PicturePlan& plan, int subpixel_bits);

}  // namespace ps::hardware
