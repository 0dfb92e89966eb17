// Stability experiments on rays, triangles and boxes against rates measured elsewhere.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "support/curve.h"
#include "support/trials.h"

namespace {

using namespace ps;
using test::Curve;

/// Three standard deviations of a rate per million when so many rays are tried.
double noise(double per_million, double rays) { return 3 * std::sqrt(per_million * 1e6 / rays); }

TEST(StabilityRays, EpsilonTooLarge) {
  const Curve curve("epsilon-too-large", 1);
  for (const auto& [epsilon, lost] : std::map<double, std::pair<double, double>>{{0.1, {.97, 4.7}}, {0.2, {8, 56}}}) {
    curve.expect_naive("point light", epsilon, lost.first);
    curve.expect_naive("directional light", epsilon, lost.second);
  }
  curve.expect_naive("directional light", 0.3, 100);
  curve.expect_naive("directional light", 1e-3, 0);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, EpsilonUnit) {
  const Curve curve("epsilon-unit");
  for (const double length : {0.1, 1.0, 3.5, 5.744562646538029, 100.0}) {
    EXPECT_NEAR(curve.naive("shadow rays", length), 1e-3 * length, 1e-6 * length);
    EXPECT_NEAR(curve.robust("shadow rays", length), 1e-3, 1e-6);
  }
}

TEST(StabilityRays, AcneFarFromTheOrigin) {
  const Curve curve("world-offset-sphere-acne", 1);
  curve.expect_naive("epsilon 0.001", 10, 0);
  for (const auto& [distance, share] : std::map<double, double>{{1e3, .03}, {1e4, .96}, {1e5, 20.2}, {1e6, 45.6}})
    curve.expect_naive("epsilon 0.001", distance, share);
  for (const auto& [distance, share] : std::map<double, double>{{1e5, .49}, {1e6, 13.6}})
    curve.expect_naive("epsilon 0.01", distance, share);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, ConstantNormalBump) {
  const Curve curve("constant-normal-bump");
  for (const double distance : {0.0, 1e3, 1e5}) curve.expect_naive("o + t d", distance, 49.5);
  for (const auto& [distance, share] : std::map<double, double>{{0, 44.7}, {1e3, 49.9}, {1e5, 48.4}})
    curve.expect_naive("from the weights", distance, share);
  for (const auto& [distance, share] : std::map<double, double>{{0, .16}, {1e3, 5.2}, {1e5, 47.5}})
    curve.expect_naive("o + t d, t > 1e-4", distance, share);
  curve.expect_naive("o + t d so many times as far from the plane as the weights' point", 0, 20);
  curve.expect_naive("normal bump 1e-4", 0, 0);
  // 20 rays leave each hit, and all of them return to a triangle or none: three standard deviations of 4,000 hits.
  curve.expect_naive("normal bump 1e-4", 1e3, .07, 100 * 3 * std::sqrt(.0007 / 4000));
  curve.expect_naive("normal bump 1e-4", 1e5, 48.3);
  for (const char* series :
       {"o + t d", "o + t d, t > 1e-4", "from the weights", "normal bump 1e-4",
        "256 representable numbers along the normal", "bound of the error, plain Moeller-Trumbore"})
    for (const double distance : {0.0, 1e3, 1e4, 1e5}) EXPECT_EQ(curve.robust(series, distance), 0) << series;
}

TEST(StabilityRays, TriangleEdgeCracks) {
  const Curve curve("triangle-edge-cracks");
  curve.expect_naive("at edges, misses", 32, 106950);
  curve.expect_naive("at edges, double hits", 32, 282816);
  curve.expect_naive("at vertices, misses", 32, 120640);
  curve.expect_naive("at edges, misses", 64, 0);
  curve.expect_naive("at edges, double hits", 64, 2, noise(2, 100000));
  curve.expect_naive("at vertices, double hits", 32, 598214);
  curve.expect_naive("at vertices, misses", 64, 4942);
  curve.expect_naive("at vertices, double hits", 64, 60742);
  curve.expect_robust("at edges, double hits", 32, 26, noise(26, 100000));
  curve.expect_robust("at vertices, double hits", 32, 832814);
  for (const char* where : {"at edges, misses", "at vertices, misses"}) EXPECT_EQ(curve.robust(where, 32), 0);
}

TEST(StabilityRays, Tolerance) {
  const Curve curve("mt-tolerance");
  curve.expect_naive("at edges, misses", 1e-6, 53817);
  curve.expect_naive("at edges, double hits", 1e-6, 448651);
  curve.expect_naive("at edges, double hits", 1e-4, 998707);
  EXPECT_EQ(curve.robust("at edges, misses", 1e-6), 0);
  curve.expect_robust("at edges, double hits", 1e-6, 26, noise(26, 100000));
}

TEST(StabilityRays, PlueckerAtVertices) {
  const Curve curve("plucker-vertices");
  curve.expect_naive("at edges, misses", 0, 0);
  curve.expect_naive("at vertices, misses", 1, 4482);
  EXPECT_EQ(curve.robust("at vertices, misses", 1), 0);
}

TEST(StabilityRays, DeterminantEpsilon) {
  const Curve curve("absolute-det-epsilon");
  for (const auto& [radius, share] : std::map<double, double>{{.05, 15.7}, {.02, 55}, {.01, 100}})
    curve.expect_naive("epsilon 1e-7", radius, share);
  for (const auto& [radius, share] : std::map<double, double>{{.01, 25}, {.001, 100}})
    curve.expect_naive("epsilon 1e-8", radius, share);
  // Nothing is below the threshold then: what is left are the cracks along edges.
  curve.expect_naive("epsilon 1e-7", 2, 10.7551);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, Contraction) {
  const Curve curve("fma-contraction");
  if (curve.empty()) GTEST_SKIP() << "no fused multiply-add on this processor";
  if (test::trial_divisor > 1) GTEST_SKIP() << "sanitized code is not contracted";
  curve.expect_naive("watertight (Woop)", 1, 488, noise(488, 100000));
  EXPECT_EQ(curve.robust("watertight (Woop)", 1), 0);
  curve.expect_naive("Moeller-Trumbore", 1, 165196);
  curve.expect_naive("Moeller-Trumbore", 0, 106246);
}

TEST(StabilityRays, BuildFlags) {
  const Curve curve("build-flags");
  EXPECT_EQ(curve.naive("-O0", 1), 0) << "optimisation changes no pixel";
  if (curve.has("-ffast-math", 3)) curve.expect_naive("-ffast-math", 3, 240);
}

TEST(StabilityRays, CracksInAPicture) {
  const Curve curve("cracks-in-an-image");
  EXPECT_LE(curve.naive("float", 512), 4);
  // One in five of the middle column: 426 of 2049 elsewhere.
  curve.expect_naive("float", 513, 426.0 * 513 / 2049);
  curve.expect_naive("double", 513, 118.0 * 513 / 2049, 3 * std::sqrt(30.0));
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, SlabTest) {
  const Curve curve("slab-test-false-miss");
  for (const auto& [dimensions, misses] : std::map<double, double>{{3, 41880}, {2, 138342}, {1, 289814}})
    curve.expect_naive("near <= far", dimensions, misses);
  curve.expect_naive("near < far", 3, 307189);
  curve.expect_naive("near < far", 2, 1e6);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, HolesInATree) {
  const Curve curve("bvh-holes");
  for (const auto& [distance, misses] : std::map<double, double>{{0, 11650}, {1e3, 11313}, {1e5, 10390}})
    curve.expect_naive("rays at vertices", distance, misses, noise(misses, 40000));
  curve.expect_naive("cost", 0, 74.0);
  curve.expect_robust("cost", 0, 74.9);
  for (const double distance : {0.0, 1e3, 1e5}) {
    EXPECT_EQ(curve.robust("rays at vertices", distance), 0);
    EXPECT_LT(curve.robust("cost", distance), 1.05 * curve.naive("cost", distance)) << "1.2 % more nodes elsewhere";
  }
  curve.expect_naive("rays at edges", 1e5, 2137, noise(2137, 40000));
  EXPECT_EQ(curve.robust("rays at edges", 1e5), 0);
}

TEST(StabilityRays, ZeroTimesInfinity) {
  const Curve curve("0-inf-nan-slab");
  EXPECT_EQ(curve.naive("max(t0, near), in the planes of two sides", 0), 75);
  EXPECT_EQ(curve.naive("max(near, t0), in the plane of one side", 0), 50);
  EXPECT_EQ(curve.naive("swap if t0 > t1, direction +0", 1), 0);
  EXPECT_EQ(curve.naive("swap if t0 > t1, direction -0", -1), 100);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, GridBorders) {
  const Curve curve("grid-octree-borders");
  for (const auto& [series, shares] :
       std::map<std::string, std::array<double, 3>>{{"centres alone", {3.5, 33, 88.7}},
                                                    {"mailbox and t <= cell exit", {13.1, 43.6, 76.8}},
                                                    {"first hit wins", {1.2, 1.6, 2.7}}}) {
    double knob = 4;
    for (const double share : shares) {
      curve.expect_naive(series, knob, share);
      knob *= 4;
    }
  }
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, NaNVertex) {
  const Curve curve("nan-vertex");
  EXPECT_EQ(curve.naive("tree of halves", 0), 0);
  curve.expect_naive("tree of halves", 1, 62.3);
  curve.expect_all_robust_zero();
}

TEST(StabilityRays, InfiniteVertex) {
  const Curve curve("infinite-vertex");
  const std::string soup = "5,000 triangles anywhere", rings = "a sphere in rings";
  const auto bad = static_cast<double>(1e38f), large = static_cast<double>(1e18f);
  curve.expect_naive(soup, bad, 123.3);
  curve.expect_robust(soup, bad, 32.5);
  const double slower = curve.naive(soup, bad) / curve.robust(soup, bad);
  EXPECT_GT(slower, 3.8 / 1.5) << "seed " << curve.seed();
  EXPECT_LT(slower, 3.8 * 1.5) << "seed " << curve.seed();
  EXPECT_LT(curve.naive(rings, bad), 2 * curve.robust(rings, bad)) << "neighbours stay together";
  for (const std::string& series : {soup, rings})
    EXPECT_LT(curve.naive(series, large), 1.1 * curve.robust(series, large)) << "squares are finite";
}

TEST(StabilityRays, NaNInMoellerTrumbore) {
  const Curve curve("nan-in-moller-trumbore");
  for (const char* bad : {"NaN vertex", "all NaN", "infinite vertex", "NaN direction", "coordinates of 1e30"}) {
    EXPECT_EQ(curve.naive(bad, 0), 1) << bad;
    EXPECT_EQ(curve.robust(bad, 0), 0) << bad;
  }
  for (const char* miss : {"a point", "collinear", "direction 0", "coordinates of 1e-30"})
    EXPECT_EQ(curve.naive(miss, 0) + curve.robust(miss, 0), 0) << miss;
  EXPECT_EQ(curve.naive("a triangle ahead", 0) + curve.robust("a triangle ahead", 0), 2);
}

TEST(StabilityRays, DegenerateShapes) {
  const Curve curve("degenerate-zero-radius");
  for (const char* bad : {"radius -1", "radius NaN", "direction 0", "centre at 1e20"}) {
    EXPECT_EQ(curve.naive(bad, 0), 1) << bad;
    EXPECT_EQ(curve.robust(bad, 0), 0) << bad;
  }
  EXPECT_EQ(curve.naive("radius infinite, t of the hit", 0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(curve.naive("a ball ahead", 0) + curve.robust("a ball ahead", 0), 2);
  for (const char* radius : {"0", "-1", "nan", "inf", "1e400"})
    EXPECT_EQ(curve.robust(std::string("scene file with radius ") + radius, 0), 0) << radius;
}

TEST(StabilityRays, NaNInAPicture) {
  const Curve curve("nan-in-a-picture");
  for (const double width : {1.0, 3.0, 5.0, 9.0, 15.0}) {
    EXPECT_EQ(curve.naive("blur, one NaN pixel", width), width * width);
    EXPECT_EQ(curve.robust("blur, one NaN pixel", width), 0);
  }
  for (const double width : {3.0, 5.0, 9.0, 15.0}) {
    EXPECT_EQ(curve.naive("blur by a running sum", width), 100);
    EXPECT_EQ(curve.robust("blur by a running sum", width), 0);
  }
  EXPECT_EQ(curve.naive("running mean of samples", 0), 100);
  EXPECT_EQ(curve.robust("running mean of samples", 0), 0);
  for (const auto& [how, left] :
       std::map<std::string, double>{{"std::clamp(x, 0, 1)", 1}, {"min(max(x, 0), 1)", 1}, {"max(0, min(1, x))", 0}}) {
    EXPECT_EQ(curve.naive("NaN left by " + how, 0), left) << how;
    EXPECT_EQ(curve.robust("NaN left by " + how, 0), 0) << how;
  }
  EXPECT_EQ(curve.naive("value of the NaN pixel after max(0, min(1, x))", 0), 1);
  EXPECT_EQ(curve.naive("check of the error, a NaN in the picture", 0), 1) << "passes";
  EXPECT_EQ(curve.robust("check of the error, a NaN in the picture", 0), 0);
  const std::string control = "check of the error, the right picture";
  EXPECT_EQ(curve.naive(control, 0) + curve.robust(control, 0), 2);
  EXPECT_EQ(curve.robust("not finite, counted before the error", 0), 1);
}

}  // namespace
