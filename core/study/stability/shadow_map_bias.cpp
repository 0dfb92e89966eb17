#include <array>

#include <fmt/format.h>

#include "raster/shadow/shadow_lookup.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

using raster::ShadowComparison;
using raster::ShadowMap;

constexpr double ball_radius = 0.5;
const Vec3d ball_centre{0, ball_radius, 0};

/// A ball on a floor of 8 x 8, with the sun at an elevation. The map is laid around the floor: moving that moves the
/// ball between texels.
Scene ball_on_floor(double elevation, const Vec3d& moved = Vec3d(0)) {
  Scene scene;
  scene.materials = Part<std::vector<Material>>({Material{}});
  Geometry geometry;
  geometry.objects.push_back({"floor", Solid{Rectangle{Vec3d(-4, 0, -4) + moved, {0, 0, 8}, {8, 0, 0}}, 0}});
  geometry.objects.push_back({"ball", Sphere{ball_centre, ball_radius, 0}});
  scene.geometry = Part<Geometry>(std::move(geometry));
  Light sun{LightKind::directional, 1};
  sun.direction = {0, std::sin(elevation * pi / 180), std::cos(elevation * pi / 180)};
  scene.lights = Part<std::vector<Light>>({sun});
  return scene;
}

ShadowMap map_of(const Scene& scene, int size, const StabilityRun& run) {
  run.check();
  Settings settings;
  settings.shadow_map_size = size;
  settings.tessellation = 0.05;
  Prepared prepared;
  Progress own;
  return raster::shadow_maps(scene, settings, prepared, WorkerPriority::normal, run.progress ? *run.progress : own)
      ->front();
}

double texel(const ShadowMap& map) { return 2 * map.half / map.size; }

/// How far the sun's ray from a point passes by the middle of the ball; infinity behind it.
double distance_to_ball(const Vec3d& point, const Vec3d& to_sun) {
  const Vec3d across = ball_centre - point;
  const double along = dot(across, to_sun);
  const Vec3d rest = across - to_sun * along;
  return along < 0 ? everywhere : std::sqrt(dot(rest, rest));
}

double seen(const ShadowMap& map, const Vec3d& point, const ShadowComparison<double>& how) {
  Silent nobody;
  return raster::look_up_shadow(map, 0, point, Vec3d(0, 1, 0), how, nobody);
}

/// Mean darkness (%) of floor that the sun reaches. `seen(point)` is the share of the sun that a point sees.
template <class Seen>
double acne(const Scene& scene, const ShadowMap& map, const StabilityRun& run, Seen&& seen) {
  Random random(run.seed);
  const Vec3d to_sun = scene.lights->front().direction;
  const int points = run.count(100000, 20000);
  double dark = 0;
  for (int lit = 0; lit < points;) {
    const Vec3d point{random.between(-3.5, 3.5), 0, random.between(-3.5, 3.5)};
    if (distance_to_ball(point, to_sun) < ball_radius + 12 * texel(map)) continue;
    ++lit;
    dark += 1 - seen(point);
  }
  return percent(dark, points);
}

double acne(const Scene& scene, const ShadowMap& map, const ShadowComparison<double>& how, const StabilityRun& run) {
  return acne(scene, map, run, [&](const Vec3d& point) { return seen(map, point, how); });
}

/// Percentage of the shadow within 0.15 of the place where the ball touches the floor that is lit. `seen(point)` is
/// the share of the sun that a point sees.
template <class Seen>
double contact_lost(const Scene& scene, const StabilityRun& run, Seen&& seen) {
  Random random(run.seed);
  const Vec3d to_sun = scene.lights->front().direction;
  const int points = run.count(20000, 5000);
  double lost = 0;
  for (int shadowed = 0; shadowed < points;) {
    const Vec3d point{random.between(-0.15, 0.15), 0, random.between(-0.15, 0.15)};
    if (!(std::hypot(point.x, point.z) < 0.15) || distance_to_ball(point, to_sun) > ball_radius) continue;
    ++shadowed;
    lost += seen(point);
  }
  return percent(lost, points);
}

double contact_lost(const Scene& scene, const ShadowMap& map, const ShadowComparison<double>& how,
                    const StabilityRun& run) {
  return contact_lost(scene, run, [&](const Vec3d& point) { return seen(map, point, how); });
}

/// Floor in the ball's shadow that is lit, as a percentage of the floor within 1 of the place where the ball stands.
double shadow_lost(const Scene& scene, const ShadowMap& map, const ShadowComparison<double>& how,
                   const StabilityRun& run) {
  Random random(run.seed);
  const Vec3d to_sun = scene.lights->front().direction;
  const int points = run.count(400000, 20000);
  double lost = 0;
  for (int i = 0; i < points;) {
    const Vec3d point{random.between(-1, 1), 0, random.between(-1, 1)};
    if (std::hypot(point.x, point.z) > 1) continue;
    ++i;
    if (distance_to_ball(point, to_sun) <= ball_radius) lost += seen(map, point, how);
  }
  return percent(lost, points);
}

/// The share of taps x taps that see the sun, each compared with the depth that the floor has in the tap's own middle.
double seen_by_plane(const ShadowMap& map, const Vec3d& point, int taps) {
  const Vec3d up(0, 1, 0);
  const auto here = raster::find_on_map(map, point, up);
  // How a step along the floor moves on the map: the floor's depth is linear in both of the map's axes.
  const auto across = raster::find_on_map(map, point + Vec3d(1, 0, 0), up);
  const auto along = raster::find_on_map(map, point + Vec3d(0, 0, 1), up);
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

std::vector<StabilityRow> measure_acne(const StabilityRun& run) {
  Rows rows(run);
  for (const int size : {256, 1024, 4096})
    for (const double elevation : {60.0, 30.0, 10.0}) {
      const Scene scene = ball_on_floor(elevation);
      const ShadowMap map = map_of(scene, size, run);
      const double robust = acne(scene, map, {0, 0.52, 1}, run);
      for (const double bias : {0.0, 0.001, 0.01, 0.05}) {
        rows.push_back({bias, fmt::format("{} texels, sun at {} degrees", size, elevation),
                        acne(scene, map, {bias, 0, 1}, run), robust, "% of lit floor dark"});
        // The formula of the same: what half a texel's slope has left over the bias, over texel and slope.
        const double slope = 1 / std::tan(elevation * pi / 180);
        rows.push_back({bias, fmt::format("{} texels, sun at {} degrees, by formula", size, elevation),
                        100 * std::max(0.0, 0.5 - bias / (texel(map) * slope)), 0, "% of lit floor dark"});
      }
    }
  return rows;
}

/// The slope bias (texels) for so many taps in a row: to the middle of the outermost, and half of it with some to
/// spare.
double slope_for(int taps) {
  const int aside = taps / 2;
  return aside + 0.6;
}

std::vector<StabilityRow> measure_filter(const StabilityRun& run) {
  const Scene scene = ball_on_floor(30);
  const ShadowMap map = map_of(scene, 512, run);
  Rows rows(run);
  for (const int taps : {1, 3, 5, 7}) {
    const double naive = acne(scene, map, {0, 1, taps}, run);
    const double plane = acne(scene, map, run, [&](const Vec3d& point) { return seen_by_plane(map, point, taps); });
    rows.push_back({static_cast<double>(taps), "sun at 30 degrees", naive,
                    acne(scene, map, {0, slope_for(taps), taps}, run), "% of lit floor dark"});
    rows.push_back({static_cast<double>(taps), "sun at 30 degrees, taps on the receiver's plane", naive, plane,
                    "% of lit floor dark"});
  }
  return rows;
}

/// The map of a ball that touches the floor in the corner of four texels. The map is laid around floor and ball, so by
/// moving the floor it moves half as far.
ShadowMap map_with_contact_in_a_corner(double elevation, int size, Scene& scene, const StabilityRun& run) {
  scene = ball_on_floor(elevation);
  const ShadowMap first = map_of(scene, size, run);
  const double row = raster::find_on_map(first, Vec3d(0), Vec3d(0, 1, 0)).position.y;
  const double off = (row - std::floor(row)) * texel(first);  // the map has to move by this, upwards as the sun sees it
  scene = ball_on_floor(elevation, Vec3d(0, 0, 2 * off / std::sin(elevation * pi / 180)));
  return map_of(scene, size, run);
}

std::vector<StabilityRow> measure_peter_panning(const StabilityRun& run) {
  constexpr double elevation = 10;
  const ShadowComparison<double> half_texel{0, 0.52, 1}, filtered{0, 3.5, 5};
  Rows rows(run);
  for (const int size : {256, 1024, 4096}) {
    Scene scene;
    const ShadowMap map = map_with_contact_in_a_corner(elevation, size, scene, run);
    const double robust = contact_lost(scene, map, half_texel, run);
    const std::string series = fmt::format("{} texels, sun at 10 degrees", size);
    for (const double bias : {0.01, 0.05, 0.1, 0.2, 0.4})
      rows.push_back({bias, series, contact_lost(scene, map, {bias, 0, 1}, run), robust, "% of contact shadow lost"});
    rows.push_back({0, series + ", 5 x 5 taps with the slope of 3.5 texels", contact_lost(scene, map, filtered, run),
                    robust, "% of contact shadow lost"});
    rows.push_back({0, series + ", 5 x 5 taps on the receiver's plane",
                    contact_lost(scene, run, [&](const Vec3d& point) { return seen_by_plane(map, point, 5); }), robust,
                    "% of contact shadow lost"});
    // Lifted by this much the point sees past the texel whose middle lies half a texel down the slope.
    const double lift = 0.6 * texel(map);
    const auto lifted = [&](const Vec3d& point) { return seen(map, point + Vec3d(0, lift, 0), {}); };
    rows.push_back({0, series + ", receiver lifted by 0.6 texels", contact_lost(scene, run, lifted), robust,
                    "% of contact shadow lost"});
  }
  const Scene high_sun = ball_on_floor(60);
  for (const int size : {256, 1024, 4096})
    rows.push_back({0, fmt::format("{} texels, sun at 60 degrees, whole shadow", size),
                    shadow_lost(high_sun, map_of(high_sun, size, run), half_texel, run), std::nan(""),
                    "% of the floor around loses its shadow"});
  return rows;
}

StabilityPicture picture(double bias) {
  StabilityPicture picture{.scene = "lab/shadow-acne", .width = 240, .height = 160};
  picture.robust.renderer = Renderer::rasterizer;
  picture.robust.shadows = Shadows::map;
  picture.robust.shadow_map_size = 256;
  picture.robust.shadow_bias = 0;
  picture.robust.shadow_slope_bias = 0.52;
  picture.naive = picture.robust;
  picture.naive.shadow_bias = bias;
  picture.naive.shadow_slope_bias = 0;
  return picture;
}

StabilityPicture picture_filter(double taps) {
  StabilityPicture result = picture(0);
  result.naive.shadow_filter = result.robust.shadow_filter = static_cast<int>(taps);
  result.naive.shadow_slope_bias = 1;
  result.robust.shadow_slope_bias = slope_for(result.robust.shadow_filter);
  return result;
}

constexpr std::array biases{0.0, 0.01, 0.05, 0.2};
constexpr std::array taps{1.0, 3.0, 5.0, 7.0};
constexpr std::array large_biases{0.01, 0.1, 0.2, 0.5};

}  // namespace

const StabilityExperiment shadow_map_acne{
    .key = "shadow-map-acne",
    .title = "Shadow map acne",
    .knob = "constant bias (world units)",
    .naive = "constant bias",
    .robust = "slope bias of half a texel",
    .explanation =
        "A texel knows the depth in its middle; half a texel farther down the slope the surface lies deeper "
        "and takes itself for shadowed. The lower the light, the steeper the slope and the more bias is needed.",
    .safe = "Half a texel times the slope, for the lowest light of the scene.",
    .window = {0.05, everywhere},
    .measure = measure_acne,
    .picture = picture,
    .frames = biases};

const StabilityExperiment pcf_one_tap_bias{
    .key = "pcf-one-tap-bias",
    .title = "A filter with the bias of one tap",
    .knob = "taps along a side",
    .naive = "slope bias of one texel",
    .robust = "slope bias of half the filter and a little more",
    .explanation = "The outer taps of a filter lie texels away down the slope, where the surface is deeper by as many "
                   "slopes. With a bias of one texel one of three taps is dark half the time.",
    .safe = "One tap.",
    .window = {1, 1},
    .measure = measure_filter,
    .picture = picture_filter,
    .frames = taps};

const StabilityExperiment peter_panning{
    .key = "peter-panning",
    .title = "Shadows that come off",
    .knob = "constant bias (world units)",
    .naive = "constant bias",
    .robust = "slope bias of half a texel",
    .explanation =
        "A bias large enough to cure acne under a low sun jumps over the thin part of an object where it "
        "touches the ground, and more texels do not help against a constant. What half a texel's slope loses "
        "is the jagged front of the shadow, more or less as the ball falls between texels: here it touches the floor "
        "in the corner of four.",
    .safe = "Biases far below the size of objects.",
    .window = {nowhere, 0.02},
    .measure = measure_peter_panning,
    .picture = picture,
    .frames = large_biases};

}  // namespace ps::stability
