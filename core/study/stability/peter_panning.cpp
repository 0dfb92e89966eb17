#include <fmt/format.h>

#include "study/stability/shadow_map_ball.h"

namespace ps::stability::peter_panning {
namespace {

using raster::ShadowComparison;
using raster::ShadowMap;

/// Balls at places of a floor, anywhere within 0.5 of its centre, each with its map: what is lost of a shadow depends
/// on where the ball falls between texels.
class Places {
 public:
  Places(double elevation, int size, int count, const StabilityRun& run) : run_(run) {
    Random random(run.seed);
    for (int i = 0; i < count; ++i) {
      const double x = random.between(-0.5, 0.5);
      balls_.push_back(ball_on_floor(elevation, {x, 0, random.between(-0.5, 0.5)}));
      maps_.push_back(shadow_map_of(balls_.back().scene, size, run));
    }
  }

  /// Percentage of the shadow within 0.15 of the contact that is lit, a mean over the places. `seen(map, point)` is the
  /// share of the sun that a point of the floor sees.
  template <class Seen>
  double contact_lost(Seen&& seen) const {
    const int points = run_.count(20000, 5000) / static_cast<int>(balls_.size());
    double lost = 0;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      run_.check();
      Random random(run_.seed);
      for (int shadowed = 0; shadowed < points;) {
        const Vec3d aside(random.between(-0.15, 0.15), 0, random.between(-0.15, 0.15));
        const Vec3d point = balls_[i].contact + aside;
        if (!(std::hypot(aside.x, aside.z) < 0.15) || balls_[i].distance_to_centre(point) > BallOnFloor::radius)
          continue;
        ++shadowed;
        lost += seen(maps_[i], point);
      }
    }
    return percent(lost, points * static_cast<double>(balls_.size()));
  }
  double contact_lost(const ShadowComparison<double>& how) const {
    return contact_lost(
        [&](const ShadowMap& map, const Vec3d& point) { return sun_seen(map, point, BallOnFloor::up, how); });
  }

  /// Lit floor in the whole shadow, as a percentage of the floor within 1 of the contact.
  double shadow_lost(const ShadowComparison<double>& how) const {
    const int points = run_.count(400000, 20000) / static_cast<int>(balls_.size());
    double lost = 0;
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      run_.check();
      Random random(run_.seed);
      for (int i = 0; i < points;) {
        const Vec3d aside(random.between(-1, 1), 0, random.between(-1, 1));
        if (std::hypot(aside.x, aside.z) > 1) continue;
        ++i;
        const Vec3d point = balls_[k].contact + aside;
        if (balls_[k].distance_to_centre(point) <= BallOnFloor::radius)
          lost += sun_seen(maps_[k], point, BallOnFloor::up, how);
      }
    }
    return percent(lost, points * static_cast<double>(balls_.size()));
  }

 private:
  const StabilityRun& run_;
  std::vector<BallOnFloor> balls_;
  std::vector<ShadowMap> maps_;
};

/// Where texels are small, all places are much the same.
int places_for(int size, int most) { return size > 1024 ? 1 : most; }

void measure(const StabilityRun& run, Rows& rows) {
  const std::string unit = "% of contact shadow lost";
  const ShadowComparison<double> half_texel{0, slope_bias_of_floors(1), 1};
  for (const int size : {256, 1024, 4096}) {
    const Places places(10, size, places_for(size, 16), run);
    const double robust = places.contact_lost(half_texel);
    const std::string series = fmt::format("{} texels, sun at 10 degrees", size);
    for (const double bias : {0.01, 0.05, 0.1, 0.2, 0.4})
      rows.add(bias, series, places.contact_lost({bias, 0, 1}), robust, unit);
    rows.add(0, series + ", 5 x 5 taps, slope bias of 3.5 texels", places.contact_lost({0, 3.5, 5}), robust, unit);
    rows.add(
        0, series + ", 5 x 5 taps on the receiver's plane",
        places.contact_lost([](const ShadowMap& map, const Vec3d& point) { return sun_seen_by_plane(map, point, 5); }),
        robust, unit);
    // The point is looked up above the floor by as much as half a texel's slope is deep (Holbein 2011, normal offset).
    rows.add(0, series + ", receiver lifted by half a texel",
             places.contact_lost([](const ShadowMap& map, const Vec3d& point) {
               return sun_seen(map, point + BallOnFloor::up * (0.5 * texel_of(map)), BallOnFloor::up, {});
             }),
             robust, unit);
  }
  for (const int size : {256, 1024, 4096})
    rows.add(0, fmt::format("{} texels, sun at 60 degrees, whole shadow", size),
             Places(60, size, places_for(size, 4), run).shadow_lost(half_texel), std::nan(""),
             "% of the floor around loses its shadow");
}

/// The ball from near by, and a thin post. Fine triangles keep what the map holds close to what the eye sees.
StabilityPicture picture(double bias) {
  StabilityPicture picture{.scene = R"(
viewport_size = 1.5 x 1
projection_plane_d = 1
background = (200, 214, 230)
camera { position = (0.3, 0.9, -2.4)  rotation = <-18 degrees around the X axis> }
rectangle { name = floor  corner = (-4, 0, -4)  side_a = (8, 0, 0)  side_b = (0, 0, 8)  color = white }
sphere { name = ball  center = (-0.3, 0.5, 0)  radius = 0.5  color = (220, 60, 40) }
box { name = post  center = (1, 0.3, -0.4)  size = (0.12, 0.6, 0.12)  color = (60, 110, 200) }
light { type = ambient  intensity = 0.25 }
light { type = directional  intensity = 0.75  direction = (-1, 0.35, -0.4) }
)",
                           .width = 240,
                           .height = 160};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.robust.shadows = Shadows::map;
  picture.robust.tessellation = 0.05;
  picture.robust.shadow_bias = 0;
  picture.robust.shadow_slope_bias = slope_bias_of_all(1);
  picture.naive = picture.robust;
  picture.naive.shadow_bias = bias;
  picture.naive.shadow_slope_bias = 0;
  return picture;
}

}  // namespace

extern const StabilityExperiment peter_panning{
    .key = "peter-panning",
    .place = {Subject::shadows, 30},
    .title = "Peter-panning: detached shadows",
    .keywords = "bias, shadow map, depth bias, light leak, floating shadow",
    .knob = "constant bias (world units)",
    .naive = "constant bias",
    .robust = "slope bias of half a texel and 1/256",
    .explanation = "A bias large enough to cure acne under a low sun is larger than the thin part of an object where "
                   "it touches the ground. The shadow then begins too late, and more texels do not help. A slope bias "
                   "of half a texel only loses the jagged front of the shadow, which more texels make smaller.",
    .safe = "Biases far below the size of objects.",
    .window = {nowhere, 0.02},
    .series = {{.names = "1024 texels, sun at 10 degrees|256 texels, sun at 10 degrees|4096 texels, sun at 10 degrees",
                .title = "contact shadow that is lost",
                .unit = "%"},
               {.names = "*10 degrees, *", .title = "contact shadow that is lost by other methods", .unit = "%"},
               {.names = "*whole shadow", .title = "floor around the object that loses its shadow", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {0.4, 0.2, 0.1, 0.05, 0.02}};

}  // namespace ps::stability::peter_panning
