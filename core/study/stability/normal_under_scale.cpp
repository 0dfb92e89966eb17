#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "scene/world.h"
#include "shade/illumination.h"
#include "study/stability/support.h"

namespace ps::stability::normal_under_scale {
namespace {

struct LambertError {
  double rmse = 0;   ///< levels of 255
  double flips = 0;  ///< percentage of places that the light reaches with one normal only
};

/// What the program's illumination makes of a white place under a directional light of intensity 1, in levels of 255.
double lambert_levels(const Vec3d& normal, const Vec3d& to_light) {
  const std::array<ShadingLight<double>, 1> lights{
      ShadingLight<double>{.kind = LightKind::directional, .vector = to_light}};
  const auto nothing_blocks = [](int, const Vec3d&, double) { return Blocking<double>{std::nullopt}; };
  Silent silent;
  return 255 * illuminate<double>(LitPoint<double>{.normal = normal}, ShadingMaterial<double>{}, lights, {},
                                  nothing_blocks, silent)
                   .light.x;
}

/// The diffuse light of a stretched ball, with these normals against those of its own surface, at places spread evenly
/// before it was stretched. The light comes along the diagonal of the axes.
LambertError lambert_error(const Transform& transform, const Mat3d& normals, const StabilityRun& run) {
  const Vec3d to_light = glm::normalize(Vec3d(1, 1, 1));
  Random random(run.seed);
  const int places = run.count(200000, 20000);
  double squares = 0, flips = 0;
  for (int i = 0; i < places; ++i) {
    const Vec3d place = random.direction();
    // The gradient of the stretched ball's equation |p / scale| = 1.
    const Vec3d right = glm::normalize(to_world(transform, place) / (transform.scale * transform.scale));
    const double light = lambert_levels(normal_to_world(normals, place), to_light);
    const double truth = lambert_levels(right, to_light);
    squares += (light - truth) * (light - truth);
    // The same place to within rounding is not a flip.
    flips += (light > 0) != (truth > 0) && std::abs(light - truth) > 1e-9 ? 1 : 0;
  }
  return {std::sqrt(squares / places), percent(flips, places)};
}

}  // namespace

/// Planes x + y/m = const for many slopes m, stretched by s along x: the angle between the transformed normal and the
/// normal of the transformed plane, whose direction in the plane is known.
static void measure_normal_under_scale(const StabilityRun& run, Rows& rows) {
  constexpr double degrees = 57.29577951308232;
  for (const double scale : {1.0, 1.5, 2.0, 5.0, 10.0, 100.0}) {
    run.check();
    Transform transform;
    transform.scale = {scale, 1, 1};
    const Mat3d model = normal_matrix(transform, NormalTransform::model);
    const Mat3d inverse = normal_matrix(transform, NormalTransform::inverse_transpose);
    double naive = 0, robust = 0;
    for (int i = 0; i <= 90000; ++i) {
      const double angle = i / 1000.0 / degrees;
      const Vec3d normal(std::cos(angle), std::sin(angle), 0);
      const Vec3d in_plane = to_world(transform, {-std::sin(angle), std::cos(angle), 0});
      const auto tilt = [&](const Mat3d& matrix) {
        const double sine = dot(normal_to_world(matrix, normal), in_plane) / glm::length(in_plane);
        return std::asin(std::clamp(std::abs(sine), 0.0, 1.0)) * degrees;
      };
      naive = std::max(naive, tilt(model));
      robust = std::max(robust, tilt(inverse));
    }
    rows.add(scale, "all slopes", naive, robust, "degrees");
    const LambertError wrong = lambert_error(transform, model, run), right = lambert_error(transform, inverse, run);
    rows.add(scale, "diffuse light of a ball", wrong.rmse, right.rmse, "RMSE, levels");
    rows.add(scale, "ball lit or not", wrong.flips, right.flips, "% of its places differ");
  }
}

extern const StabilityExperiment normal_under_scale{
    .key = "normal-under-scale",
    .place = {Subject::shading, 30},
    .set_up = SetUp::reproduction,
    .title = "Normal transformation: normals under a scale",
    .keywords = "inverse transpose, normal matrix, non-uniform scale",
    .knob = "scale along one axis",
    .naive = "transform like positions",
    .robust = "inverse transpose",
    .explanation = "A plane that is stretched tilts one way and its normal, stretched with it, the other. The inverse "
                   "transpose keeps normal and plane perpendicular.",
    .safe = "Uniform scales only.",
    .window = {1, 1},
    .series = {{.names = "all slopes", .title = "largest error of the normal", .unit = "degrees"},
               {.names = "diffuse light*", .title = "error of the diffuse light (RMSE)", .unit = "levels of 255"},
               {.names = "ball lit*", .title = "places of the ball on the wrong side of the terminator", .unit = "%"}},
    .add_rows = measure_normal_under_scale};

}  // namespace ps::stability::normal_under_scale
