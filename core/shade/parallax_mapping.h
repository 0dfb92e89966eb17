#pragma once
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "math/unit.h"
#include "options/settings.h"
#include "record/events.h"
#include "shade/normal_mapping.h"

namespace ps {

/// Parallax mapping, shared by both renderers: a flat surface is the top of a relief whose heights a picture holds, and
/// its texture is read where the line of sight meets the relief below (Kaneko et al. 2001; CGFS ch. 15 names it beside
/// normal mapping). Depths run from 0 at the surface (white) to 1 at the bottom (black).

/// How far u and v run along the line of sight from the top of a relief to its bottom. `normal` and `to_eye` may have
/// any length; `frame` as triangle_frame() gives it, whose directions are dP/du and -dP/dv but for one common factor,
/// which cancels. `depth` is that of the bottom, in widths of the picture. nullopt where the surface is seen edge-on or
/// from behind. Parallax::limited leaves out the division by the cosine, so that the shift is never longer than the
/// depth (Welsh 2004).
template <class Real>
inline std::optional<Vec2<Real>> relief_shift(const Vec3<Real>& normal, const TangentFrame<Real>& frame,
                                              const Vec3<Real>& to_eye, Real depth, Parallax method) {
  const Vec3<Real> n = unit_of(normal);
  const Vec3<Real> v = unit_of(to_eye);
  const Real cosine = dot(n, v);
  if (!(cosine > 0)) return {};
  Vec3<Real> along = n * cosine - v;  // within the surface, for a cosine of depth
  if (method != Parallax::limited) along = along / cosine;
  // along * width = du * dP/du + rise * (-dP/dv), by the normal equations.
  const Real uu = dot(frame.along_u, frame.along_u), uw = dot(frame.along_u, frame.upwards);
  const Real ww = dot(frame.upwards, frame.upwards);
  const Real area = uu * ww - uw * uw;
  if (!(area > 0)) return {};
  const Real scale = depth * std::sqrt(uu) / area;
  const Real a = dot(along, frame.along_u), b = dot(along, frame.upwards);
  return Vec2<Real>((a * ww - b * uw) * scale, -((b * uu - a * uw) * scale));
}

/// Where the relief is met.
template <class Real>
struct ReliefPoint {
  Real depth = 0;  ///< share of the shift that is added to the texture coordinates
  int reads = 0;   ///< of the height map
};

/// Follows the line of sight down into the relief. `relief(share)` reads the relief's depth at uv + share * shift.
/// Offset and limited take the depth right below the surface point for that where the line ends. Steep walks `steps`
/// equal steps down and stops at the first that lies inside (McGuire and McGuire 2005); occlusion then takes the point
/// where straight lines through the last two readings cross (Tatarchuk 2006).
template <class Real, class Relief>
inline ReliefPoint<Real> meet_relief(Parallax method, int steps, Relief&& relief) {
  ReliefPoint<Real> point;
  Real below = relief(Real(0));
  point.reads = 1;
  switch (method) {
  case Parallax::off:
    return {};
  case Parallax::offset:
  case Parallax::limited:
    point.depth = below;
    return point;
  case Parallax::steep:
  case Parallax::occlusion:
    break;
  }
  Real ray = 0;
  for (int i = 1; i <= steps && below > ray; ++i) {
    const Real before = below, ray_before = ray;
    ray = static_cast<Real>(i) / static_cast<Real>(steps);
    below = relief(ray);
    ++point.reads;
    point.depth = ray;
    if (below > ray || method == Parallax::steep) continue;
    const Real gap_before = before - ray_before, gap = ray - below;  // above the relief, then inside it
    point.depth = ray_before + (ray - ray_before) * (gap_before / (gap_before + gap));
  }
  return point;
}

/// The texture coordinates behind a relief. `depth_at(uv)` reads the map; where the recorder keeps events, what it
/// gave is noted. Reports a ParallaxEvent.
template <class Real, class Recorder, class DepthAt>
inline Vec2<Real> parallax_uv(int texture, const Vec2<Real>& uv, const Vec2<Real>& shift, const Settings& settings,
                              DepthAt&& depth_at, Recorder& recorder) {
  std::vector<double> notes;
  const ReliefPoint<Real> point = meet_relief<Real>(settings.parallax, settings.parallax_steps, [&](Real share) {
    const Real depth = depth_at(Vec2<Real>(uv.x + shift.x * share, uv.y + shift.y * share));
    if constexpr (Recorder::records) notes.push_back(static_cast<double>(depth));
    return depth;
  });
  const Vec2<Real> seen(uv.x + shift.x * point.depth, uv.y + shift.y * point.depth);
  recorder.event([&] {
    return ParallaxEvent{texture,         Vec2d(uv), Vec2d(seen), Vec2d(shift), static_cast<double>(point.depth),
                         std::move(notes)};
  });
  return seen;
}

}  // namespace ps
