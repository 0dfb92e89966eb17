#include "raster/base/clip.h"

#include <cmath>

namespace ps::raster {
namespace {

template <class Real>
ClipPlane<Real> make_plane(Vec3d normal, double offset, RejectReason reason, std::string_view name) {
  const double length = std::sqrt(dot(normal, normal));
  return {Vec3<Real>(normal / length), static_cast<Real>(offset / length), reason, name};
}

template <class Real>
ClipVertex<Real> mix(const ClipVertex<Real>& inner, const ClipVertex<Real>& outer, Real t) {
  const auto lerp = [t](const Vec3<Real>& a, const Vec3<Real>& b) {
    return Vec3<Real>{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
  };
  return {lerp(inner.position, outer.position), lerp(inner.weights, outer.weights)};
}

}  // namespace

template <class Real>
std::vector<ClipPlane<Real>> make_clip_planes(const Settings& settings, const Viewport<double>& viewport) {
  std::vector<ClipPlane<Real>> planes;
  if (settings.clipping == Clipping::none) return planes;
  const double d = viewport.distance;
  planes.push_back(make_plane<Real>({0, 0, 1}, -settings.near * d, RejectReason::clipped_near, "near plane"));
  if (settings.clipping == Clipping::full) {
    const auto projection = make_canvas_projection<double>(viewport);
    const double half_width = (projection.centre.x + 1) / projection.scale.x;
    const double half_height = (projection.centre.y + 1) / projection.scale.y;
    const bool perspective = projection.kind == Projection::perspective;
    const auto side = [&](Vec3d inward, double half, std::string_view name) {
      if (perspective) inward.z = half;
      planes.push_back(make_plane<Real>(inward, perspective ? 0 : half, RejectReason::clipped_side, name));
    };
    side({1, 0, 0}, half_width, "left plane");
    side({-1, 0, 0}, half_width, "right plane");
    side({0, -1, 0}, half_height, "top plane");
    side({0, 1, 0}, half_height, "bottom plane");
  }
  if (settings.far < no_far_limit)
    planes.push_back(make_plane<Real>({0, 0, -1}, settings.far * d, RejectReason::clipped_far, "far plane"));
  return planes;
}

template <class Real>
ClipOutcome clip_polygon(ClipPolygon<Real>& polygon, const ClipPlane<Real>& plane) {
  std::array<Real, ClipPolygon<Real>::capacity> distance{};
  int inside = 0;
  for (int i = 0; i < polygon.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    distance[k] = plane.distance(polygon.corners[k].position);
    if (distance[k] >= 0) ++inside;
  }
  if (inside == polygon.size) return ClipOutcome::inside;
  if (inside == 0) return ClipOutcome::outside;
  ClipPolygon<Real> kept;
  for (int i = 0; i < polygon.size; ++i) {
    const auto here = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>((i + 1) % polygon.size);
    const auto& a = polygon.corners[here];
    const auto& b = polygon.corners[next];
    const bool a_inside = distance[here] >= 0;
    const bool b_inside = distance[next] >= 0;
    if (a_inside) kept.push(a);
    if (a_inside && !b_inside) kept.push(mix(a, b, distance[here] / (distance[here] - distance[next])));
    if (!a_inside && b_inside) kept.push(mix(b, a, distance[next] / (distance[next] - distance[here])));
  }
  polygon = kept;
  return ClipOutcome::split;
}

template <class Real>
bool clip_segment(Vec3<Real>& a, Vec3<Real>& b, const std::vector<ClipPlane<Real>>& planes) {
  for (const auto& plane : planes) {
    const Real da = plane.distance(a);
    const Real db = plane.distance(b);
    if (!(da >= 0) && !(db >= 0)) return false;
    if (da >= 0 && db >= 0) continue;
    if (da >= 0)
      b = a + (b - a) * (da / (da - db));
    else
      a = b + (a - b) * (db / (db - da));
  }
  return true;
}

// NOLINTBEGIN(bugprone-macro-parentheses): Real is a type
#define PS_INSTANTIATE(Real)                                                                                           \
  template std::vector<ClipPlane<Real>> make_clip_planes(const Settings&, const Viewport<double>&);                    \
  template ClipOutcome clip_polygon(ClipPolygon<Real>&, const ClipPlane<Real>&);                                       \
  template bool clip_segment(Vec3<Real>&, Vec3<Real>&, const std::vector<ClipPlane<Real>>&);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace ps::raster
