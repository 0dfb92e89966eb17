#pragma once
#include "frame/viewport.h"
#include "scene/camera.h"

namespace ps {

/// The picture on its projection plane in world space, with the renderers' own mapping (frame/viewport.h).
class SpaceImage {
 public:
  SpaceImage(const View& view, const Settings& settings)
      : camera_(view.camera), viewport_(make_viewport<double>(view, settings)) {}

  /// World position of a canvas position in pixels from the picture's top left corner.
  Vec3d at(const Vec2d& canvas) const { return at_depth(canvas, viewport_.distance); }
  /// World position of the visible point at a canvas position at depth `z` along the camera's forward axis.
  Vec3d at_depth(const Vec2d& canvas, double z) const {
    const Vec2d across = viewport_position(canvas);
    const double spread = viewport_.projection == Projection::perspective ? z / viewport_.distance : 1.0;
    return camera_.position + (camera_.right * across.x + camera_.up * across.y) * spread + camera_.forward * z;
  }
  /// Where the line of sight through a canvas position begins.
  Vec3d eye(const Vec2d& canvas) const { return at_depth(canvas, 0); }
  /// Canvas position of the sample of a pixel.
  Vec2d sample(Vec2i pixel) const { return Vec2d(pixel) + viewport_.sample; }
  /// Depth of the near plane for a setting of `near`.
  double near_depth(double near) const { return near * viewport_.distance; }
  int columns() const { return viewport_.columns; }
  int rows() const { return viewport_.rows; }

 private:
  Vec2d viewport_position(const Vec2d& canvas) const {
    return {(canvas.x - viewport_.columns / 2.0) * viewport_.width / viewport_.span_x,
            (viewport_.rows / 2.0 - canvas.y) * viewport_.height / viewport_.span_y};
  }
  Camera camera_;
  Viewport<double> viewport_;
};

}  // namespace ps
