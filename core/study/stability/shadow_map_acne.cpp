#include <array>

#include <fmt/format.h>

#include "study/stability/shadow_map_ball.h"

namespace ps::stability::shadow_map_acne {
namespace {

using raster::ShadowComparison;
using raster::ShadowMap;

/// Mean darkness (%) of floor that the sun reaches. `seen(point)` is the share of the sun that a point sees.
template <class Seen>
double acne(const BallOnFloor& ball, const ShadowMap& map, const StabilityRun& run, Seen&& seen) {
  Random random(run.seed);
  const int points = run.count(100000, 20000);
  double dark = 0;
  for (int lit = 0; lit < points;) {
    const Vec3d point{random.between(-3.5, 3.5), 0, random.between(-3.5, 3.5)};
    if (ball.distance_to_centre(point) < BallOnFloor::radius + 12 * texel_of(map)) continue;
    ++lit;
    dark += 1 - seen(point);
  }
  return percent(dark, points);
}

double acne(const BallOnFloor& ball, const ShadowMap& map, const ShadowComparison<double>& how,
            const StabilityRun& run) {
  return acne(ball, map, run, [&](const Vec3d& point) { return sun_seen(map, point, BallOnFloor::up, how); });
}

/// The darkness (%) of a roof, 8 x 8, that leans to the side by 45 degrees under the sun at 30 degrees, for each of
/// some slope biases. Its depth grows almost along the diagonal of a texel.
std::array<double, 2> acne_on_roof(int size, const std::array<double, 2>& slope_biases, const StabilityRun& run) {
  Scene scene = ball_on_floor(30).scene;
  const double lean = std::sqrt(0.5);
  const Vec3d corner(-4 * lean, 4 * lean, -4), side_a(0, 0, 8), side_b(8 * lean, -8 * lean, 0), normal(lean, lean, 0);
  Geometry geometry;
  geometry.objects.push_back({"roof", Solid{Rectangle{corner, side_a, side_b}, 0}});
  scene.geometry = Part<Geometry>(std::move(geometry));
  const ShadowMap map = shadow_map_of(scene, size, run);
  std::array<double, 2> dark{};
  for (std::size_t i = 0; i < dark.size(); ++i) {
    Random random(run.seed);
    const int points = run.count(100000, 20000);
    for (int k = 0; k < points; ++k) {
      const Vec3d point = corner + side_a * random.between(0.1, 0.9) + side_b * random.between(0.1, 0.9);
      dark[i] += percent(1 - sun_seen(map, point, normal, {0, slope_biases[i], 1}), points);
    }
  }
  return dark;
}

void measure_acne(const StabilityRun& run, Rows& rows) {
  const std::string unit = "% of lit floor dark";
  for (const int size : {256, 1024, 4096})
    for (const double elevation : {60.0, 30.0, 10.0}) {
      const BallOnFloor ball = ball_on_floor(elevation);
      const ShadowMap map = shadow_map_of(ball.scene, size, run);
      const double robust = acne(ball, map, {0, slope_bias_of_floors(1), 1}, run);
      const std::string series = fmt::format("{} texels, sun at {} degrees", size, elevation);
      for (const double bias : {0.0, 0.001, 0.01, 0.05}) {
        rows.add(bias, series, acne(ball, map, {bias, 0, 1}, run), robust, unit);
        const double depth_of_texel = texel_of(map) / std::tan(elevation * pi / 180);
        rows.add(bias, series + ", closed form: 1/2 - bias / depth of a texel",
                 100 * std::max(0.0, 0.5 - bias / depth_of_texel), std::nan(""), unit);
      }
      if (size != 1024 || elevation != 10) continue;
      for (const double texels : {0.125, 0.25, 0.375, 0.5})
        rows.add(texels, series + ", slope bias (texels)", acne(ball, map, {0, texels, 1}, run), robust, unit);
    }
  const auto [naive, robust] = acne_on_roof(1024, {slope_bias_of_floors(1), slope_bias_of_all(1)}, run);
  rows.add(0.5, "1024 texels, leaning roof, slope bias (texels)", naive, robust, "% of lit roof dark");
}

void measure_filter(const StabilityRun& run, Rows& rows) {
  const BallOnFloor ball = ball_on_floor(30);
  const ShadowMap map = shadow_map_of(ball.scene, 512, run);
  for (const int taps : {1, 3, 5, 7}) {
    const double naive = acne(ball, map, {0, 1, taps}, run);
    const double plane = acne(ball, map, run, [&](const Vec3d& point) { return sun_seen_by_plane(map, point, taps); });
    rows.add(taps, "sun at 30 degrees", naive, acne(ball, map, {0, slope_bias_of_floors(taps), taps}, run),
             "% of lit floor dark");
    rows.add(taps, "sun at 30 degrees, taps on the receiver's plane", naive, plane, "% of lit floor dark");
  }
}

StabilityPicture picture_filter(double taps) {
  StabilityPicture picture{.scene = "lab/shadow-acne", .width = 240, .height = 160};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.robust.shadows = Shadows::map;
  picture.robust.shadow_map_size = 256;
  picture.robust.shadow_bias = 0;
  picture.robust.shadow_filter = static_cast<int>(taps);
  picture.robust.shadow_slope_bias = slope_bias_of_all(picture.robust.shadow_filter);
  picture.naive = picture.robust;
  picture.naive.shadow_slope_bias = 1;
  return picture;
}

StabilityPicture picture_acne(double bias) {
  StabilityPicture picture = picture_filter(1);
  picture.naive.shadow_bias = bias;
  picture.naive.shadow_slope_bias = 0;
  return picture;
}

}  // namespace

extern const StabilityExperiment shadow_map_acne{
    .key = "shadow-map-acne",
    .place = {Subject::shadows, 10},
    .set_up = SetUp::reproduction,
    .title = "Shadow map acne",
    .keywords = "shadow acne, bias, depth bias, slope scale, self-shadowing",
    .knob = "constant bias (world units)",
    .naive = "constant bias",
    .robust = "slope bias of half a texel and 1/256",
    .explanation =
        "A texel stores the depth at its centre. Half a texel farther down the slope the surface lies deeper than that "
        "and shadows itself; the lower the light, the more bias it needs. Half a texel times the slope is enough where "
        "the slope runs along the map's axes, as on a floor; 0.71 texels are enough for any surface.",
    .safe = "A slope bias of half a texel and 1/256 on floors, of 0.71 texels and 1/256 on any surface.",
    .window = {0.05, everywhere},
    .series = {{.names = "1024 texels, sun at 10 degrees|*", .title = "lit floor that is dark", .unit = "%"},
               {.names = "*slope bias (texels)",
                .title = "lit floor that is dark",
                .unit = "%",
                .knob = "slope bias (texels)"},
               {.names = "1024 texels, leaning roof*",
                .title = "lit roof that is dark",
                .unit = "%",
                .knob = "slope bias (texels)"}},
    .add_rows = measure_acne,
    .picture = picture_acne,
    .frames = {0.0, 0.01, 0.05, 0.2}};

extern const StabilityExperiment pcf_one_tap_bias{
    .key = "pcf-one-tap-bias",
    .place = {Subject::shadows, 20},
    .set_up = SetUp::reproduction,
    .title = "PCF: percentage-closer filtering with the bias of one tap",
    .keywords = "PCF, shadow map, acne, soft shadow, bias",
    .knob = "taps along a side",
    .naive = "slope bias of one texel",
    .robust = "slope bias of half the taps and 1/256",
    .explanation = "The outer taps of a filter lie several texels away, where a sloping surface is nearer to the "
                   "light. With a bias of one texel, one of three rows of taps is dark half of the time. A filter with "
                   "k taps on each side needs a slope bias of k + 1/2 texels.",
    .safe = "One tap.",
    .window = {1, 1},
    .series = {{.names = "*", .title = "lit floor that is dark", .unit = "%", .between = Between::nothing}},
    .add_rows = measure_filter,
    .picture = picture_filter,
    .frames = {7.0, 5.0, 3.0, 1.0}};

}  // namespace ps::stability::shadow_map_acne
