#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "base/check.h"
#include "study/stability/experiment.h"
#include "support/curve.h"
#include "support/trials.h"

namespace {

using namespace ps;

using test::Curve;

/// Relative error of a float sum of random numbers.
double sum_error(int samples, std::uint32_t seed) {
  std::mt19937 random(seed);
  float sum = 0;
  double truth = 0;
  for (int i = 0; i < samples; ++i) {
    const float sample = static_cast<float>(random() >> 8) * 0x1p-24f;
    sum += sample;
    truth += static_cast<double>(sample);
  }
  return std::abs(static_cast<double>(sum) - truth) / truth;
}

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
  curve.expect_naive("float", 1e-3, 5.69);
  curve.expect_naive("float", 1e-2, 0.18);
  curve.expect_naive("double", 1e-3, 0);
  curve.expect_naive("double", 1e-4, 0);
  curve.expect_all_robust_zero();
}

TEST(Stability, RaySphereCancellation) {
  const Curve curve("ray-sphere-cancellation", test::trial_divisor > 1 ? 0.5 : 1);
  const std::string wrong = "hit or miss", place = "place";
  for (const auto& [distance, share] :
       std::map<double, double>{{3, 0}, {100, .037}, {1000, 2.5}, {2000, 9.9}, {4100, 42.5}, {1e5, 47.7}, {1e6, 48.1}})
    curve.expect_naive(wrong, distance, share);
  for (const double distance : {3.0, 100.0, 1000.0}) curve.expect_robust(wrong, distance, 0);
  // Single rays of 200,000: three standard deviations of their number.
  curve.expect_robust(wrong, 2000, .001, 100 * 3 * std::sqrt(2.0) / 200000);
  curve.expect_robust(wrong, 4100, .0025, 100 * 3 * std::sqrt(5.0) / 200000);
  curve.expect_robust(wrong, 1e5, .02);
  curve.expect_robust(wrong, 1e6, 1.0);
  for (const auto& [distance, off] : std::map<double, double>{
           {3, 2.5e-7}, {100, 3.2e-4}, {1000, .023}, {2000, .094}, {4100, .41}, {1e5, 16.5}, {1e6, 152}})
    curve.expect_naive(place, distance, off);
  for (const auto& [distance, off] : std::map<double, double>{
           {3, 8.6e-8}, {100, 2.9e-6}, {1000, 2.3e-5}, {2000, 4.7e-5}, {4100, 1.3e-4}, {1e5, .003}, {1e6, .024}})
    curve.expect_robust(place, distance, off);
  curve.expect_naive("hit or miss, textbook in double", 4100, 0);
  curve.expect_naive("hit or miss, textbook in double", 1e6, .007, 100 * 3 * std::sqrt(14.0) / 200000);
  curve.expect_naive("place, textbook in double", 4100, 1.6e-9);
  curve.expect_naive("place, textbook in double", 1e6, 6e-5);
}

TEST(Stability, StableRootsAlone) {
  const Curve curve("stable-q-alone", 1);
  for (const auto& [distance, share] : std::map<double, double>{{1000, 2.5}, {2000, 9.9}, {4100, 42.5}})
    curve.expect_naive("hit or miss", distance, share);
}

TEST(Stability, InterpolateDrift) {
  const Curve curve("interpolate-drift");
  for (const auto& [steps, error] :
       std::map<double, double>{{100, .003}, {600, .018}, {1e3, .03}, {1e4, .30}, {1e5, 3.0}, {1e6, 29}})
    curve.expect_naive("float", steps, error);
  for (const double steps : {100.0, 1e4, 1e6}) curve.expect_robust("float", steps, 6e-5);
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
  for (const double share : {1.0, 24.0, 25.0, 50.0, 75.0, 99.0}) EXPECT_EQ(curve.robust("white over black", share), 0);
  EXPECT_EQ(curve.naive("white over black, level shown", 50), 128);
  EXPECT_EQ(curve.robust("white over black, level shown", 50), 188);
}

// The error of one sum is a random walk, so the given figures tell its size, not its value: the root mean square over
// eight seeds is within a factor of 2.5 of them.
TEST(Stability, SampleAccumulation) {
  for (const auto& [samples, error] : std::map<int, double>{{1000, 4e-7}, {100000, 3e-6}, {1000000, 8e-6}}) {
    double squares = 0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) squares += std::pow(sum_error(samples, seed), 2);
    const double rms = std::sqrt(squares / 8);
    EXPECT_LT(rms, 2.5 * error) << samples;
    EXPECT_GT(rms, error / 2.5) << samples;
  }
  const Curve curve("sample-accumulation");
  EXPECT_NEAR(curve.at("uniform samples", 1e8).naive, 0.664, 0.002) << "the sum stops at 2^24";
  EXPECT_LT(curve.at("uniform samples", 1e8).robust, 1.2e-7);
}

TEST(Stability, RefractionTotalInternal) {
  const Curve curve("refraction-total-internal", 1);
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
  EXPECT_EQ(stability_experiments().size(), 66u);
  for (const StabilityExperiment& experiment : stability_experiments()) {
    EXPECT_EQ(&find_stability_experiment(experiment.key), &experiment);
    for (const std::string_view text : {experiment.title, experiment.knob, experiment.naive, experiment.robust,
                                        experiment.explanation, experiment.safe})
      EXPECT_FALSE(text.empty()) << experiment.key;
    EXPECT_TRUE(experiment.measure) << experiment.key;
    const auto sentences = std::count(experiment.explanation.begin(), experiment.explanation.end(), '.');
    EXPECT_GE(sentences, 2) << experiment.key;
  }
  EXPECT_THROW(find_stability_experiment("nothing"), InputError);
  EXPECT_EQ(stability_csv(std::vector<StabilityRow>{{0.5, "a", 1, std::nan(""), "px"}}),
            "knob,series,naive,robust,unit\n0.5,\"a\",1,,\"px\"\n");
}

}  // namespace
