#include "study/stability/shadow_map_ball.h"

#include <cmath>

#include "raster/maps.h"

namespace ps::stability {

using raster::ShadowMap;

double BallOnFloor::distance_to_centre(const Vec3d& point) const {
  const Vec3d across = contact + up * radius - point;
  const double along = dot(across, to_sun);
  const Vec3d rest = across - to_sun * along;
  return along < 0 ? everywhere : std::sqrt(dot(rest, rest));
}

BallOnFloor ball_on_floor(double elevation, const Vec3d& contact) {
  BallOnFloor result;
  result.contact = contact;
  result.to_sun = {0, std::sin(elevation * pi / 180), std::cos(elevation * pi / 180)};
  Scene& scene = result.scene;
  scene.materials = Part<std::vector<Material>>({Material{}});
  Geometry geometry;
  geometry.objects.push_back({"floor", Solid{Rectangle{{-4, 0, -4}, {0, 0, 8}, {8, 0, 0}}, 0}});
  geometry.objects.push_back({"ball", Sphere{contact + BallOnFloor::up * BallOnFloor::radius, BallOnFloor::radius, 0}});
  scene.geometry = Part<Geometry>(std::move(geometry));
  Light sun{LightKind::directional, 1};
  sun.direction = result.to_sun;
  scene.lights = Part<std::vector<Light>>({sun});
  return result;
}

ShadowMap shadow_map_of(const Scene& scene, int size, const StabilityRun& run) {
  run.check();
  Settings settings;
  settings.shadow_map_size = size;
  settings.tessellation = 0.05;
  Prepared prepared;
  Progress own;
  return raster::shadow_maps(scene, settings, prepared, WorkerPriority::normal, run.progress ? *run.progress : own)
      ->front();
}

double sun_seen(const ShadowMap& map, const Vec3d& point, const Vec3d& normal,
                const raster::ShadowComparison<double>& how) {
  Silent silent;
  return raster::look_up_shadow(map, 0, point, normal, how, silent);
}

double sun_seen_by_plane(const ShadowMap& map, const Vec3d& point, int taps) {
  const auto here = raster::find_on_map(map, point, BallOnFloor::up);
  // How a step along the floor moves on the map: the floor's depth is linear in both of the map's axes.
  const auto across = raster::find_on_map(map, point + Vec3d(1, 0, 0), BallOnFloor::up);
  const auto along = raster::find_on_map(map, point + Vec3d(0, 0, 1), BallOnFloor::up);
  const Vec2d a = across.position - here.position, b = along.position - here.position;
  const double area = a.x * b.y - a.y * b.x, da = across.depth - here.depth, db = along.depth - here.depth;
  const Vec2d slope((da * b.y - db * a.y) / area, (db * a.x - da * b.x) / area);
  const int aside = taps / 2;
  int lit = 0;
  for (int j = -aside; j <= aside; ++j)
    for (int i = -aside; i <= aside; ++i) {
      const int x = static_cast<int>(std::floor(here.position.x)) + i;
      const int y = static_cast<int>(std::floor(here.position.y)) + j;
      const double plane = here.depth + dot(slope, Vec2d(x + 0.5, y + 0.5) - here.position);
      const double stored = static_cast<double>(map.faces.front().at(x, y));
      lit += stored < plane - 1e-4 ? 0 : 1;  // the map holds floats
    }
  return lit / static_cast<double>(taps * taps);
}

}  // namespace ps::stability
