#include <array>

#include <fmt/format.h>

#include "raster/clip.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

constexpr double near = 0.1;
constexpr int side = 300;

using Triangle = std::array<Vec3d, 3>;

/// Two corners before the camera; the third one passes below and beside it and goes behind it, as a floor's does. What
/// is wrong depends on where: a corner that passes above changes from half of the picture to a fifteenth and back.
Triangle with_apex(double z) { return {Vec3d(-1.5, -1, 3), Vec3d(1.5, -1, 3), Vec3d(1, -0.5, z)}; }

/// What an exact ray through the pixel meets, beyond the near plane.
bool truth(const Triangle& p, double x, double y) {
  const Vec3d d(x, y, 1), e1 = p[1] - p[0], e2 = p[2] - p[0];
  const Vec3d h = cross(d, e2);
  const double det = dot(e1, h);
  if (det == 0) return false;
  const Vec3d s = -p[0], q = cross(s, e1);
  const double u = dot(s, h) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= near;
}

bool covers(const Vec2d& a, const Vec2d& b, const Vec2d& c, double x, double y) {
  const auto edge = [&](const Vec2d& p, const Vec2d& q) { return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x); };
  const double u = edge(b, c), v = edge(c, a), w = edge(a, b);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

enum class Way { no_clip, drop, clamp_z, absolute_z, clip };

bool drawn(const Triangle& p, Way way, double x, double y) {
  const auto project = [&](const Vec3d& v) {
    double z = v.z;
    if (way == Way::clamp_z) z = std::max(z, near);
    if (way == Way::absolute_z) z = std::abs(z);
    return Vec2d(v.x / z, v.y / z);
  };
  switch (way) {
  case Way::drop:
    if (p[0].z < near || p[1].z < near || p[2].z < near) return false;
    break;
  case Way::clip: {
    raster::ClipPolygon<double> polygon;
    for (const Vec3d& corner : p) polygon.push({corner, {}});
    raster::clip_polygon(polygon, raster::ClipPlane<double>{{0, 0, 1}, -near, RejectReason::clipped_near, "near"});
    for (int i = 1; i + 1 < polygon.size; ++i) {
      const auto at = [&](int k) { return project(polygon.corners[static_cast<std::size_t>(k)].position); };
      if (covers(at(0), at(i), at(i + 1), x, y)) return true;
    }
    return false;
  }
  case Way::no_clip:
  case Way::clamp_z:
  case Way::absolute_z:
    break;
  }
  return covers(project(p[0]), project(p[1]), project(p[2]), x, y);
}

/// Percentage of the picture that is wrong, the viewport being 2 x 2 at distance 1.
double wrong_share(const Triangle& triangle, Way way) {
  double wrong = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.4871) / side * 2 - 1, y = 1 - (row + 0.5113) / side * 2;
      wrong += drawn(triangle, way, x, y) != truth(triangle, x, y) ? 1 : 0;
    }
  return percent(wrong, side * side);
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  for (const double z : {3.0, 1.0, 0.6, 0.2, -0.2, -1.0, -3.0, -10.0}) {
    run.check();
    const Triangle triangle = with_apex(z);
    const double robust = wrong_share(triangle, Way::clip);
    for (const auto& [way, name] : {std::pair{Way::no_clip, "no clipping"},
                                    {Way::drop, "drop the triangle"},
                                    {Way::clamp_z, "clamp z"},
                                    {Way::absolute_z, "take |z|"}})
      rows.push_back({z, name, wrong_share(triangle, way), robust, "% of the picture wrong"});
  }
  return rows;
}

}  // namespace

const StabilityExperiment near_plane_clipping{
    .key = "near-plane-clipping",
    .title = "Corners behind the camera",
    .knob = "z of one corner",
    .naive = "project it all the same, or some way round it",
    .robust = "clip at the near plane",
    .explanation = "A point behind the camera is projected to the opposite side, at z = 0 to nowhere. Only cutting the "
                   "triangle where it leaves the visible space keeps the rest of it right.",
    .safe = "Triangles wholly before the near plane.",
    .window = {near, everywhere},
    .measure = measure};

}  // namespace ps::stability
