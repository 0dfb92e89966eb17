#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "math/vec.h"
#include "options/settings.h"
#include "raster/setup/projection.h"
#include "record/events.h"

namespace ps::raster {

/// A plane in camera space; points with distance(p) >= 0 are kept. The normal has length 1.
template <class Real>
struct ClipPlane {
  Vec3<Real> normal{0, 0, 1};
  Real offset = 0;
  RejectReason reason = RejectReason::clipped_near;
  std::string_view name;

  Real distance(const Vec3<Real>& p) const { return normal.x * p.x + normal.y * p.y + normal.z * p.z + offset; }
};

/// The clipping volume (CGFS ch. 11), in the order in which triangles are tested: near, left, right, top, bottom, and
/// far where `far` is a limit at all. The side planes run one pixel outside the picture, so that no sample ever lies on
/// an edge that clipping made.
template <class Real>
std::vector<ClipPlane<Real>> make_clip_planes(const Settings& settings, const Viewport<double>& viewport);

/// A vertex of a triangle while it is being cut: where it is, and its weights with respect to the original vertices,
/// from which every attribute follows.
template <class Real>
struct ClipVertex {
  Vec3<Real> position{0, 0, 0};  ///< camera space
  Vec3<Real> weights{0, 0, 0};
};

/// A convex polygon with room for a triangle cut by six planes and then by the guard band.
template <class Real>
struct ClipPolygon {
  static constexpr int capacity = 16;
  std::array<ClipVertex<Real>, capacity> corners{};
  int size = 0;
  void push(const ClipVertex<Real>& corner) { corners[static_cast<std::size_t>(size++)] = corner; }
};

enum class ClipOutcome { inside, outside, split };

/// Cuts a polygon, keeping the part in front of the plane. New vertices are computed from the inner end of an edge to
/// the outer one, so two triangles that share an edge get the same new vertex, bit for bit.
template <class Real>
ClipOutcome clip_polygon(ClipPolygon<Real>& polygon, const ClipPlane<Real>& plane);

/// Shortens the segment a..b (camera space) to its part in front of all planes; false if nothing is left.
template <class Real>
bool clip_segment(Vec3<Real>& a, Vec3<Real>& b, const std::vector<ClipPlane<Real>>& planes);

}  // namespace ps::raster
