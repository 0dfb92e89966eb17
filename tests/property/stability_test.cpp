#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "base/check.h"
#include "options/scene_settings.h"
#include "render/display_frame.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/stability/experiment.h"

namespace {

using namespace ps;

/// A measured curve, found by series and knob.
class Curve {
 public:
  explicit Curve(std::string_view key) : seed_(std::random_device{}()) {
    for (const StabilityRow& row : find_stability_experiment(key).measure({seed_, nullptr}))
      rows_[{row.series, row.knob}] = row;
  }
  const StabilityRow& at(const std::string& series, double knob) const { return rows_.at({series, knob}); }
  std::uint32_t seed() const { return seed_; }
  /// Rates may lie within a factor of 1.5 of the given figure; those given as 0 must be 0.
  void expect_naive(const std::string& series, double knob, double given) const {
    expect(at(series, knob).naive, given, series, knob);
  }
  void expect_robust(const std::string& series, double knob, double given) const {
    expect(at(series, knob).robust, given, series, knob);
  }
  void expect_all_robust_zero() const {
    for (const auto& [place, row] : rows_) EXPECT_EQ(row.robust, 0) << place.first << " at " << place.second;
  }

 private:
  void expect(double value, double given, const std::string& series, double knob) const {
    SCOPED_TRACE(series + " at " + std::to_string(knob) + ", seed " + std::to_string(seed_));
    if (given == 0) {
      EXPECT_EQ(value, 0);
      return;
    }
    EXPECT_LE(value, given * 1.5);
    EXPECT_GE(value, given / 1.5);
  }
  std::uint32_t seed_;
  std::map<std::pair<std::string, double>, StabilityRow> rows_;
};

TEST(Stability, GroundSphereAcne) {
  const Curve curve("ground-sphere-acne");
  const std::string book = "radius 5000, float";
  for (const double epsilon : {0.0, 1e-6, 1e-5}) curve.expect_naive(book, epsilon, 10.9);
  curve.expect_naive(book, 1e-4, 6.09);
  curve.expect_naive(book, 1e-3, 0);
  curve.expect_naive(book, 1e-2, 0);
  curve.expect_naive("radius 5000, float, light 0.1 above", 1e-3, 10.8);
  curve.expect_naive("radius 1000, float", 1e-5, 24.2);
  curve.expect_naive("radius 1000, float", 1e-4, 0);
  curve.expect_naive("radius 100000, float", 1e-3, 1.38);
  curve.expect_naive("radius 100000, float", 1e-2, 0);
  curve.expect_naive("radius 5000, double", 0, 29.6);
  curve.expect_naive("radius 5000, double", 1e-6, 0);
  curve.expect_all_robust_zero();
}

TEST(Stability, ReflectionSelfHit) {
  const Curve curve("reflection-self-hit");
  // At the book's 0.001 the rate depends on how the eye ray's hit is rounded: 1.7 % here, 5.7 % in another program.
  EXPECT_GT(curve.at("float", 1e-3).naive, 1);
  EXPECT_LT(curve.at("float", 1e-3).naive, 8.5);
  curve.expect_naive("float", 1e-2, 0.18);
  curve.expect_naive("double", 1e-3, 0);
  curve.expect_all_robust_zero();
}

TEST(Stability, RaySphereCancellation) {
  const Curve curve("ray-sphere-cancellation");
  // A ray may pass so close to the outline that one rounding decides: less than one in 200,000 on average.
  constexpr double few = 100.0 * 3 / 200000;
  EXPECT_LE(curve.at("float", 3).naive, few) << "seed " << curve.seed();
  curve.expect_naive("float", 1000, 2.5);
  curve.expect_naive("float", 2000, 9.9);
  curve.expect_naive("float", 4100, 42.5);
  curve.expect_naive("float", 1e5, 47.7);
  for (const double distance : {3.0, 100.0, 1000.0})
    EXPECT_LE(curve.at("float", distance).robust, few) << "seed " << curve.seed();
  EXPECT_LT(curve.at("float", 4100).robust, 0.02) << "seed " << curve.seed();
}

TEST(Stability, InterpolateDrift) {
  const Curve curve("interpolate-drift");
  for (const auto& [steps, error] :
       std::map<double, double>{{100, .003}, {600, .018}, {1e3, .03}, {1e4, .30}, {1e5, 3.0}, {1e6, 29}})
    curve.expect_naive("float", steps, error);
  for (const double steps : {100.0, 1e4, 1e6}) EXPECT_LE(curve.at("float", steps).robust, 6.2e-5);
}

TEST(Stability, DepthMixedAsItIs) {
  const Curve curve("z-vs-1-z");
  for (const double ratio : {1.1, 2.0, 5.0, 10.0, 100.0, 1000.0}) {
    const double root = std::sqrt(ratio);
    EXPECT_NEAR(curve.at("largest on the edge", ratio).naive, (root - 1) / (root + 1), 1e-4) << ratio;
    EXPECT_LT(curve.at("largest on the edge", ratio).robust, 1e-12);
  }
}

TEST(Stability, NormalUnderScale) {
  const Curve curve("normal-under-scale");
  for (const double scale : {1.0, 1.5, 2.0, 5.0, 10.0, 100.0}) {
    const double degrees = 2 * std::atan(scale) * 180 / 3.14159265358979 - 90;
    EXPECT_NEAR(curve.at("all slopes", scale).naive, degrees, 1e-2) << scale;
    EXPECT_LT(curve.at("all slopes", scale).robust, 1e-6);
  }
}

TEST(Stability, RecursionDepth) {
  const Curve curve("recursion-depth");
  for (const auto& [depth, rmse] :
       std::map<double, double>{{0, 22.7}, {1, 6.37}, {2, 1.69}, {3, .398}, {4, .128}, {5, .032}, {8, .0014}})
    curve.expect_naive("book scene", depth, rmse);
}

TEST(Stability, SrgbAveraging) {
  const Curve curve("srgb-averaging");
  EXPECT_NEAR(curve.at("white over black", 50).naive, 188 - 128, 1);
  EXPECT_NEAR(curve.at("white over black", 24).naive, 73, 1);
  curve.expect_all_robust_zero();
}

TEST(Stability, SampleAccumulation) {
  const Curve curve("sample-accumulation");
  // One sum, so only the size is certain: rounding errors may cancel in one run and not in the next.
  EXPECT_LT(curve.at("uniform samples", 1000).naive, 4e-6);
  EXPECT_GT(curve.at("uniform samples", 1e8).naive, 0.5) << "the sum stops at 2^24";
  EXPECT_LT(curve.at("uniform samples", 1e8).robust, 1.2e-7);
}

TEST(Stability, RefractionTotalInternal) {
  const Curve curve("refraction-total-internal");
  curve.expect_naive("leaving the glass", 1, 0);
  const double sigma = 100 * std::sqrt(.556 * .444 / 1e6);
  EXPECT_NEAR(curve.at("leaving the glass", 1.5).naive, 100 * (1 - 1 / 2.25), 3.5 * sigma) << "seed " << curve.seed();
  curve.expect_all_robust_zero();
}

TEST(Stability, AcosOfUnitDot) {
  const Curve curve("acos-of-unit-dot");
  curve.expect_naive("float unit vectors", 1, 23.7);
  curve.expect_all_robust_zero();
}

TEST(Stability, EveryExperimentExplainsItselfAndGivesATable) {
  for (const StabilityExperiment& experiment : stability_experiments()) {
    EXPECT_EQ(&find_stability_experiment(experiment.key), &experiment);
    for (const std::string_view text : {experiment.title, experiment.knob, experiment.naive, experiment.robust,
                                        experiment.explanation, experiment.safe})
      EXPECT_FALSE(text.empty()) << experiment.key;
  }
  EXPECT_THROW(find_stability_experiment("nothing"), InputError);
  EXPECT_EQ(stability_csv(std::vector<StabilityRow>{{0.5, "a", 1, std::nan(""), "px"}}),
            "knob,series,naive,robust,unit\n0.5,\"a\",1,,\"px\"\n");
}

/// What new pictures start with never leaves the safe windows. A scene whose file asks for its book's own guard is held
/// to the picture in double with the guard that needs no epsilon.
TEST(Stability, StartingSettingsOfEveryBuiltinSceneAreSafe) {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    SCOPED_TRACE(builtin.name);
    const Scene scene = load_scene(builtin.name);
    const Settings settings = settings_for(scene);
    EXPECT_EQ(settings.slab_test, SlabTest::robust);
    const bool guarded = settings.self_hit == SelfHit::offset && settings.sphere_test == SphereTest::robust &&
                         settings.triangle_test == TriangleTest::watertight;
    if (guarded) continue;
    Settings best = settings;
    best.precision = Precision::float64;
    best.self_hit = SelfHit::offset;
    best.sphere_test = SphereTest::robust;
    best.triangle_test = TriangleTest::watertight;
    const View view{scene.camera, 160, 120};
    const Image<Rgb8> shown = display_frame(render(scene, view, settings), settings);
    const Image<Rgb8> right = display_frame(render(scene, view, best), best);
    int bad = 0;
    for (std::size_t i = 0; i < shown.pixels().size(); ++i) {
      const Rgb8 p = shown.pixels()[i], q = right.pixels()[i];
      bad += std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}) > 8 ? 1 : 0;
    }
    EXPECT_LE(bad, 160 * 120 / 1000) << "pixels more than 8 levels off";
  }
}

}  // namespace
