#pragma once
#include <algorithm>
#include <limits>
#include <numbers>

#include "raster/shadow/shadow_map.h"
#include "record/recorder.h"

namespace ps::raster {

/// The knobs of a comparison with a shadow map.
template <class Real>
struct ShadowComparison {
  Real bias = 0;           ///< world units
  Real slope_bias = 0;     ///< texels, times how much depth a texel's width adds on the receiving surface; < 0: derived
  int filter = 1;          ///< taps along each side
  Real surface_error = 0;  ///< world units: how far triangles may lie within the round surface; for a derived bias
};

/// The slope bias, in texels, at which no surface shadows itself: from the centre of a filter of `taps` x `taps` texels
/// to the farthest corner that it compares with along any direction, and 1/256 for the rounding of the map's vertices.
template <class Real>
inline Real needed_slope_bias(int taps) {
  return static_cast<Real>(taps) * std::numbers::sqrt2_v<Real> / 2 + Real(1) / 256;
}

/// How much of a depth, whatever the slope, its rounding may be: it is a float from a few operations, here and in the
/// map.
template <class Real>
inline constexpr Real rounding_of_depth = Real(0x1p-20);

/// A point as a face of a shadow map sees it.
template <class Real>
struct MapPoint {
  int face = 0;
  bool outside = false;    ///< not on the map
  Vec2<Real> position{0};  ///< texels from the top left
  Real depth = 0;
  Real texel = 0;  ///< width of a texel at that depth, world units
  Real slope = 0;  ///< depth that the surface gains along a unit across the view, at its steepest
};

template <class Real>
MapPoint<Real> find_on_map(const ShadowMap& map, const Vec3<Real>& position, const Vec3<Real>& normal) {
  MapPoint<Real> point;
  const Vec3<Real> from_light = position - Vec3<Real>(map.position);
  if (map.cube) point.face = cube_face_of(from_light);
  const CubeFace& frame = map.cube ? cube_faces()[static_cast<std::size_t>(point.face)] : map.frame;
  const Vec3<Real> local = in_face(frame, from_light);
  const Vec3<Real> n = in_face(frame, normal);
  point.depth = local.z;
  Vec3<Real> along(0, 0, 1);
  if (map.cube) {
    point.outside = !(local.z > 0);
    point.position = face_position(local, map.size);
    point.texel = 2 * local.z / static_cast<Real>(map.size);
    along = local / local.z;
  } else {
    const Real half = static_cast<Real>(map.half);
    point.outside = !(std::abs(local.x) < half && std::abs(local.y) < half);
    point.position = face_position(Vec3<Real>(local.x, local.y, half), map.size);
    point.texel = 2 * half / static_cast<Real>(map.size);
  }
  constexpr Real steepest = 100;  // at grazing light, where the surface is dark anyway
  const Real facing = std::abs(dot(n, along));
  const Real across = std::sqrt(n.x * n.x + n.y * n.y);
  point.slope = across < steepest * facing ? across / facing : (across > 0 ? steepest : Real(0));
  return point;
}

/// The depth stored in a texel, and the point's own depth to compare it with. A texel beyond a cube's edge is looked up
/// on the next face, along whose axis the point has another depth.
template <class Real>
struct MapTexel {
  int face = 0, x = 0, y = 0;
  Real depth = 0;
  float stored = 0;
};

template <class Real>
MapTexel<Real> read_texel(const ShadowMap& map, const MapPoint<Real>& point, const Vec3<Real>& from_light, int x,
                          int y) {
  MapTexel<Real> texel{point.face, x, y, point.depth, std::numeric_limits<float>::infinity()};
  const bool inside = x >= 0 && y >= 0 && x < map.size && y < map.size;
  if (!inside) {
    if (!map.cube) return texel;
    const CubeFace& face = cube_faces()[static_cast<std::size_t>(point.face)];
    const Vec3<Real> local = face_direction(Vec2<Real>(Real(x) + Real(0.5), Real(y) + Real(0.5)), map.size);
    const Vec3<Real> direction =
        Vec3<Real>(face.right) * local.x + Vec3<Real>(face.up) * local.y + Vec3<Real>(face.forward) * local.z;
    texel.face = cube_face_of(direction);
    const CubeFace& next = cube_faces()[static_cast<std::size_t>(texel.face)];
    const Vec2<Real> position = face_position(in_face(next, direction), map.size);
    texel.x = std::clamp(static_cast<int>(position.x), 0, map.size - 1);
    texel.y = std::clamp(static_cast<int>(position.y), 0, map.size - 1);
    texel.depth = dot(Vec3<Real>(next.forward), from_light);
  }
  texel.stored = map.faces[static_cast<std::size_t>(texel.face)].at(texel.x, texel.y);
  return texel;
}

/// The fraction of a light that reaches a point: the fraction of texels around it whose surface is not nearer to the
/// light than the point, minus the bias (CGFS ch. 15; percentage-closer filtering where more than one is asked).
/// `normal` has any length.
template <class Real, class Recorder>
Real look_up_shadow(const ShadowMap& map, int light, const Vec3<Real>& position, const Vec3<Real>& normal,
                    const ShadowComparison<Real>& how, Recorder& recorder) {
  const MapPoint<Real> point = find_on_map(map, position, normal);
  if (point.outside) {
    recorder.event([&] {
      ShadowMapEvent event;
      event.light = light;
      event.cube = map.cube;
      event.outside = true;
      return event;
    });
    return 1;
  }
  const Vec3<Real> from_light = position - Vec3<Real>(map.position);
  const bool derived = how.slope_bias < 0;
  const Real texels = derived ? needed_slope_bias<Real>(how.filter) : how.slope_bias;
  Real bias = how.bias + texels * point.texel * point.slope;
  if (derived)
    bias += rounding_of_depth<Real> * std::abs(point.depth) +
            how.surface_error * std::sqrt(Real(1) + point.slope * point.slope);
  // The taps whose centre is nearest to the position; an odd number has the position's own texel in its middle.
  const auto first = [&](Real place) {
    const int texel = static_cast<int>(std::floor(how.filter % 2 == 0 ? place + Real(0.5) : place));
    return std::clamp(texel, 0, map.size - 1) - how.filter / 2;
  };
  const int column = first(point.position.x), row = first(point.position.y);
  int lit = 0, taps = 0;
  std::vector<ShadowTap> read;
  for (int y = row; y < row + how.filter; ++y) {
    for (int x = column; x < column + how.filter; ++x) {
      const MapTexel<Real> texel = read_texel(map, point, from_light, x, y);
      const bool sees = !(static_cast<Real>(texel.stored) < texel.depth - bias);
      ++taps;
      if (sees) ++lit;
      if constexpr (Recorder::records) read.push_back({texel.x, texel.y, static_cast<double>(texel.stored), sees});
    }
  }
  recorder.count(Counter::shadow_map_taps, static_cast<std::uint64_t>(taps));
  const Real visible = static_cast<Real>(lit) / static_cast<Real>(taps);
  recorder.event([&] {
    ShadowMapEvent event;
    event.light = light;
    event.face = point.face;
    event.cube = map.cube;
    event.position = Vec2d(point.position);
    event.depth = static_cast<double>(point.depth);
    event.bias = static_cast<double>(bias);
    event.taps = std::move(read);
    event.visible = static_cast<double>(visible);
    return event;
  });
  return visible;
}

/// The fraction of a light that reaches a point by the light's map, compared as the settings say. Fragments and rays
/// ask this one function. `surface_error` as in ShadowComparison.
template <class Real, class Recorder>
Real share_by_map(const ShadowMaps& maps, int light, const Vec3<Real>& position, const Vec3<Real>& normal,
                  const Settings& settings, Real surface_error, Recorder& recorder) {
  const ShadowComparison<Real> how{static_cast<Real>(settings.shadow_bias),
                                   static_cast<Real>(settings.shadow_slope_bias), settings.shadow_filter,
                                   surface_error};
  return look_up_shadow(maps[static_cast<std::size_t>(light)], light, position, normal, how, recorder);
}

/// Does a point that this fraction of a light reaches count as being in its shadow?
template <class Real>
inline bool is_shadowed(Real visible) {
  return !(visible > Real(0.5));
}

}  // namespace ps::raster
