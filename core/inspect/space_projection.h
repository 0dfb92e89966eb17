#pragma once
#include <optional>
#include <vector>

#include "frame/view.h"
#include "image/image.h"
#include "raster/setup/projection.h"

namespace ps {

/// A place in the space view's picture.
struct SpacePlace {
  Vec2d at{0, 0};  ///< pixels from the top left
  double z = 0;    ///< depth
};

/// A piece of a line, all of it before or all of it behind what the depth picture holds.
struct SpaceRun {
  SpacePlace from, to;
  bool hidden = false;
};

/// World to the picture of the space view, with the rasterizer's own mapping.
class SpaceProjection {
 public:
  /// What lies nearer than `near` (depth, world units) is not shown. Throws InputError for a flat camera frame.
  SpaceProjection(const View& view, const Settings& settings, double near);

  /// nullopt for a point before the near plane.
  std::optional<SpacePlace> point(const Vec3d& world) const;
  /// The part of a line in front of the near plane; nullopt if there is none.
  std::optional<SpaceRun> line(const Vec3d& from, const Vec3d& to) const;
  /// A convex polygon, cut at the near plane; empty if all of it is before it.
  std::vector<SpacePlace> polygon(const std::vector<Vec3d>& corners) const;

 private:
  Vec3d camera_point(const Vec3d& world) const { return space_.point(world); }
  SpacePlace place(const Vec3d& camera) const { return {projection_.from_top_left(camera), camera.z}; }
  raster::CameraSpace space_;
  raster::CanvasProjection<double> projection_;
  double near_;
};

/// Whether something at this place is behind what the picture shows there. Things that touch a surface count as
/// before it. Outside the picture nothing is hidden.
bool is_hidden(const Image<float>& depth, const SpacePlace& place);

/// Divides a line where it passes behind surfaces and comes forth again, to about a pixel's accuracy.
std::vector<SpaceRun> visible_runs(const Image<float>& depth, const SpaceRun& line);

}  // namespace ps
