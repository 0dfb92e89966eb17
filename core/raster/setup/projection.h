#pragma once
#include "frame/viewport.h"
#include "math/vec.h"
#include "scene/camera.h"

namespace ps::raster {

/// World to camera space (math/conventions.h). The camera's axes are used as given: a point P = position + right * x +
/// up * y + forward * z has coordinates (x, y, z) also where the axes are neither perpendicular nor of length 1.
struct CameraSpace {
  Mat3d from_world{1.0};  ///< for directions
  Vec3d position{0, 0, 0};
  /// +1 if right, up, forward follow the sense of the world's x, y, z; -1 if they mirror it. Facing is a matter of
  /// world space, so a mirrored frame turns the sense of cross products taken in camera space.
  double handedness = 1;

  Vec3d point(const Vec3d& world) const { return from_world * (world - position); }
};

/// Throws InputError for axes that lie in one plane.
CameraSpace make_camera_space(const Camera& camera);

/// Camera space to canvas (CGFS ch. 9).
template <class Real>
struct CanvasProjection {
  Vec2<Real> scale{1, 1};   ///< pixels per unit of x / z (perspective) or of x (orthographic); y likewise
  Vec2<Real> centre{0, 0};  ///< the centre of the picture, in pixels from the top left
  Projection kind = Projection::perspective;

  /// Centred canvas position, y up, in pixels. Behind the camera the formula turns points upside down; at z = 0 it has
  /// no finite value.
  Vec2<Real> centred(const Vec3<Real>& camera_point) const {
    if (kind == Projection::orthographic) return {camera_point.x * scale.x, camera_point.y * scale.y};
    return {camera_point.x * scale.x / camera_point.z, camera_point.y * scale.y / camera_point.z};
  }
  /// Position in pixels from the top left, y down.
  Vec2<Real> from_top_left(const Vec3<Real>& camera_point) const {
    const Vec2<Real> p = centred(camera_point);
    return {centre.x + p.x, centre.y - p.y};
  }
};

template <class Real>
CanvasProjection<Real> make_canvas_projection(const Viewport<double>& viewport) {
  const bool perspective = viewport.projection == Projection::perspective;
  const double distance = perspective ? viewport.distance : 1.0;
  CanvasProjection<Real> projection;
  projection.scale = {static_cast<Real>(distance * viewport.span_x / viewport.width),
                      static_cast<Real>(distance * viewport.span_y / viewport.height)};
  projection.centre = {static_cast<Real>(viewport.columns / 2.0), static_cast<Real>(viewport.rows / 2.0)};
  projection.kind = viewport.projection;
  return projection;
}

}  // namespace ps::raster
