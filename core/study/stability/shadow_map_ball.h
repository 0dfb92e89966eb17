#pragma once
#include "raster/shadow/shadow_lookup.h"
#include "study/stability/support.h"

namespace ps::stability {

/// A ball of radius 0.5 that is on a floor of 8 x 8 around the origin, under a directional light ("sun") along z.
struct BallOnFloor {
  static constexpr double radius = 0.5;
  static inline const Vec3d up{0, 1, 0};

  Scene scene;
  Vec3d contact{0, 0, 0};  ///< where the ball touches the floor
  Vec3d to_sun{0, 1, 0};   ///< length 1

  /// How far the sun's ray from a point passes by the ball's centre; infinity behind the ball.
  double distance_to_centre(const Vec3d& point) const;
};
/// `elevation` in degrees above the floor.
BallOnFloor ball_on_floor(double elevation, const Vec3d& contact = Vec3d(0));

/// The map of size x size texels that the program draws for the scene's first light.
raster::ShadowMap shadow_map_of(const Scene& scene, int size, const StabilityRun& run);

/// Width of a texel of a directional light's map, world units.
inline double texel_of(const raster::ShadowMap& map) { return 2 * map.half / map.size; }

/// The slope biases (texels) that cure acne with `taps` taps in a row: half of the taps, and 1/256, to which the
/// rasterizer rounds the vertices of the map. The slope of a floor runs along the columns of its map; other surfaces
/// may slope along the diagonal of a texel.
inline double slope_bias_of_floors(int taps) { return taps / 2.0 + 1.0 / 256; }
inline double slope_bias_of_all(int taps) { return taps * std::sqrt(0.5) + 1.0 / 256; }

/// The share of the sun that a point of a surface sees, looked up by the program.
double sun_seen(const raster::ShadowMap& map, const Vec3d& point, const Vec3d& normal,
                const raster::ShadowComparison<double>& how);

/// The same for a point of the floor with taps x taps taps, each compared with the depth that the floor has at the
/// tap's own centre (Isidoro, Shadow Mapping: GPU-based Tips and Techniques, GDC 2006). The program does not have it.
double sun_seen_by_plane(const raster::ShadowMap& map, const Vec3d& point, int taps);

}  // namespace ps::stability
