#include "inspect/space_orbit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "frame/viewport.h"

namespace ps {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double fill = 0.88;         // how much of the picture the bounds may take
constexpr double least_factor = 0.3;  // nearest that the viewer comes, of the bounds' radius

/// Gram-Schmidt from forward and up; right keeps its side.
Mat3d right_angled(const Camera& base) {
  const Vec3d forward = glm::normalize(base.forward);
  const Vec3d up = glm::normalize(base.up - forward * dot(base.up, forward));
  Vec3d right = cross(up, forward);
  if (dot(right, base.right) < 0) right = -right;
  return {right, up, forward};
}

}  // namespace

SpaceOrbit preset_orbit(SpacePreset preset, const SpaceBounds& bounds, const Camera& base, double aspect) {
  SpaceOrbit orbit;
  orbit.pivot = bounds.centre;
  switch (preset) {
  case SpacePreset::outside:
    orbit.yaw = -58 * degree;
    orbit.pitch = 24 * degree;
    break;
  case SpacePreset::front:
    break;
  case SpacePreset::side:
    orbit.yaw = -90 * degree;
    break;
  case SpacePreset::top:
    orbit.yaw = -90 * degree;
    orbit.pitch = 90 * degree;
    break;
  }
  // Each part lies before the plane through its far side that bounds the view: |y| + r <= half * (distance + z).
  const double half_height = fill * space_view_height / 2, half_width = half_height * aspect;
  const Camera axes = orbit_view(orbit, base, 1, 1).camera;
  orbit.distance = least_factor * bounds.radius;
  for (const SpaceBall& part : bounds.parts) {
    const Vec3d from_pivot = part.centre - orbit.pivot;
    const double across = std::abs(dot(from_pivot, axes.right)) + part.radius * std::hypot(1.0, half_width);
    const double upwards = std::abs(dot(from_pivot, axes.up)) + part.radius * std::hypot(1.0, half_height);
    const double needed = std::max(across / half_width, upwards / half_height) - dot(from_pivot, axes.forward);
    orbit.distance = std::max(orbit.distance, needed);
  }
  return orbit;
}

View orbit_view(const SpaceOrbit& orbit, const Camera& base, int width, int height) {
  const Mat3d axes = right_angled(base);
  const Vec3d &right = axes[0], &up = axes[1], &forward = axes[2];
  const double cy = std::cos(orbit.yaw), sy = std::sin(orbit.yaw);
  const double cp = std::cos(orbit.pitch), sp = std::sin(orbit.pitch);
  const Vec3d ahead = forward * cy + right * sy;
  View view;
  view.width = width;
  view.height = height;
  view.camera.forward = ahead * cp - up * sp;
  view.camera.up = up * cp + ahead * sp;
  view.camera.right = right * cy - forward * sy;
  view.camera.position = orbit.pivot - view.camera.forward * orbit.distance;
  view.camera.viewport_height = space_view_height;
  view.camera.viewport_width = space_view_height * width / height;
  view.camera.projection_plane_d = 1;
  return view;
}

View through_camera(const View& picture, const Settings& settings, double margin, int width, int height) {
  const Viewport<double> seen = make_viewport<double>(picture, settings);
  View view{picture.camera, width, height};
  // The image fits whichever side is tighter.
  const double aspect = static_cast<double>(width) / height;
  view.camera.viewport_height = margin * std::max(seen.height, seen.width / aspect);
  view.camera.viewport_width = view.camera.viewport_height * aspect;
  return view;
}

}  // namespace ps
