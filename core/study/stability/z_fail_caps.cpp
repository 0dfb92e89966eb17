#include <array>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// What the volume of a square roof under a light is built of and cut by.
struct Volume {
  bool caps = true;
  double extrusion = everywhere;  ///< how far below the roof it ends
  double far = everywhere;        ///< faces beyond this distance along the view are lost
};

constexpr double roof_half = 1.5, roof_height = 2, floor_y = -1;

/// Depth fail over a convex column: faces behind the surface, entered minus left, must not be zero in shadow.
bool shadowed(const Vec3d& eye, const Vec3d& direction, double t_surface, const Volume& volume) {
  const double bottom = volume.extrusion == everywhere ? -1e9 : roof_height - volume.extrusion;
  const Vec3d low(-roof_half, bottom, -roof_half), high(roof_half, roof_height, roof_half);
  double near = nowhere, far = everywhere;
  int near_axis = 0, far_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - eye[axis]) / direction[axis], b = (high[axis] - eye[axis]) / direction[axis];
    if (std::min(a, b) > near) near = std::min(a, b), near_axis = axis;
    if (std::max(a, b) < far) far = std::max(a, b), far_axis = axis;
  }
  if (!(near < far)) return false;
  const auto counts = [&](double t, int axis) {
    return t > t_surface && (volume.caps || axis != 1) && t * direction.z < volume.far;
  };
  return (counts(far, far_axis) ? 1 : 0) - (counts(near, near_axis) ? 1 : 0) != 0;
}

/// Percentage of floor pixels whose shadow is wrong.
double wrong_share(const Vec3d& eye, const Volume& volume) {
  constexpr int width = 300, height = 200;
  double floor = 0, wrong = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Vec3d direction(((column + 0.503) / width - 0.5) * 1.5, 0.5 - (row + 0.507) / height, 1);
      if (!(direction.y < 0)) continue;
      const double t = (floor_y - eye.y) / direction.y;
      const Vec3d point = eye + direction * t;
      if (point.z > 25) continue;
      ++floor;
      const bool truth = std::abs(point.x) < roof_half && std::abs(point.z) < roof_half;
      wrong += shadowed(eye, direction, t, volume) != truth ? 1 : 0;
    }
  return percent(wrong, floor);
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  const Vec3d outside(0.2, 0.3, -5), inside(0.2, 0.3, -1.4);
  const auto add = [&](double knob, const char* series, const Vec3d& eye, const Volume& volume) {
    rows.push_back({knob, series, wrong_share(eye, volume), wrong_share(eye, {}), "% of floor pixels wrong"});
  };
  add(0, "no caps, camera outside", outside, {false, 4, everywhere});
  add(0, "no caps, camera inside", inside, {false, 3.05, everywhere});
  for (const double extrusion : {1.5, 3.0, 4.0, 10.0})
    add(extrusion, "short extrusion", outside, {true, extrusion, everywhere});
  for (const double far : {4.0, 6.0, 20.0, 1000.0}) add(far, "far plane", outside, {true, everywhere, far});
  return rows;
}

}  // namespace

const StabilityExperiment z_fail_caps{
    .key = "z-fail-caps",
    .title = "Depth fail without its caps",
    .knob = "extrusion, or far plane",
    .naive = "open, short or cut volumes",
    .robust = "caps at both ends, nothing cut at the far plane",
    .explanation =
        "Depth fail counts what lies behind a surface, so the volume must be closed there. Where a view "
        "leaves through a cap that is missing, ends too early or is cut off, a face is not counted. Measured is "
        "the floor under a square roof, from 5 before its middle or from under it.",
    .safe = "Closed volumes that reach beyond everything, with a far plane at infinity.",
    .window = nowhere_safe,
    .measure = measure};

}  // namespace ps::stability
