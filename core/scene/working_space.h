#pragma once
#include <vector>

#include "scene/form_frame.h"
#include "scene/scene.h"

namespace ps {

/// Where renderers compute: in coordinates (world - origin) * scale, made in double before anything
/// is rounded. In nearly all scenes that is the world itself. Far from its origin floats lie too far apart (the
/// floating origin of large worlds), and squares of very small or very large numbers leave their range.
struct WorkingSpace {
  Vec3d origin{0, 0, 0};  ///< world units; of each axis a multiple of a power of two
  double scale = 1;       ///< a power of two: it changes no digit

  bool is_world() const { return origin == Vec3d{0, 0, 0} && scale == 1; }
  Vec3d to_world(const Vec3d& point) const { return point / scale + origin; }
  Vec3d from_world(const Vec3d& point) const { return (point - origin) * scale; }
  bool operator==(const WorkingSpace&) const = default;
};

/// The space for a scene: its origin lies near the middle of all bounded objects and the scene's own camera, or is that
/// of the world, if that is no farther away than a few times their extent. It does not depend on the view. The scale
/// brings the extent near 1 where it is below 1/4, and below 1e9 where it is above.
WorkingSpace working_space(const Scene& scene);
/// The space for the boxes_of_objects() of a scene that has objects, and for its camera.
WorkingSpace working_space(const std::vector<FormBox>& boxes, const Vec3d& eye);

/// The parts of a scene in another space. Models are shared: their instances move. Directions are scaled, too, so that
/// ray parameters stay what they are.
Geometry moved(const Geometry& geometry, const WorkingSpace& space);
std::vector<Light> moved(const std::vector<Light>& lights, const WorkingSpace& space);
Camera moved(const Camera& camera, const WorkingSpace& space);

}  // namespace ps
