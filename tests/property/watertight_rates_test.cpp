// How often rays aimed at edges and vertices slip through a closed sphere of 101,760 triangles, for the triangle tests
// of the program and for the usual variants, against rates measured elsewhere (stability rows 7 and 9 to 12). What must
// be zero is zero; the wrong variants fail on the same rays, at the known rate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>

#include "raytrace/clear/triangle_moeller_trumbore.h"
#include "raytrace/clear/triangle_watertight.h"
#include "support/closed_sphere.h"

namespace watertight_rates_test {
namespace {

using namespace ps;
using test::ClosedSphere;

constexpr unsigned seed = 20261;

struct AimedRay {
  Vec3f origin, direction;
  std::vector<std::uint32_t> candidates;  ///< all triangles that touch what the ray is aimed at
};

class Aim {
 public:
  explicit Aim(const ClosedSphere& mesh) : mesh_(mesh), around_(mesh.vertices.size()), random_(seed) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
      for (const std::uint32_t vertex : mesh.triangles[i]) around_[vertex].push_back(i);
  }

  AimedRay at_vertex() {
    const auto vertex = static_cast<std::uint32_t>(random_() % mesh_.vertices.size());
    return towards(Vec3d(mesh_.vertices[vertex]), {vertex});
  }
  AimedRay at_edge() {
    const auto& corners = mesh_.triangles[random_() % mesh_.triangles.size()];
    const auto side = static_cast<std::size_t>(random_() % 3);
    const std::uint32_t from = corners[side], to = corners[(side + 1) % 3];
    const Vec3d a(mesh_.vertices[from]), b(mesh_.vertices[to]);
    return towards(a + (b - a) * unit(), {from, to});
  }
  std::vector<AimedRay> many(AimedRay (Aim::*next)(), int count) {
    std::vector<AimedRay> rays;
    rays.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) rays.push_back((this->*next)());
    return rays;
  }

 private:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  AimedRay towards(const Vec3d& target, const std::vector<std::uint32_t>& vertices) {
    // The farther from the middle, the coarser the numbers of the origin, and the more rays pass exactly through their
    // target: with origins in this cube the rates are those measured elsewhere, in half of it a third of them.
    const Vec3f from((Vec3d(unit(), unit(), unit()) - Vec3d(0.5)) * 2.0);
    AimedRay ray{from, Vec3f(target - Vec3d(from)), {}};
    for (const std::uint32_t vertex : vertices)
      for (const std::uint32_t triangle : around_[vertex])
        if (std::find(ray.candidates.begin(), ray.candidates.end(), triangle) == ray.candidates.end())
          ray.candidates.push_back(triangle);
    return ray;
  }

  const ClosedSphere& mesh_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::mt19937_64 random_;
};

using Hits = std::function<bool(const AimedRay&, const TracedTriangle<float>&)>;

struct PerMillion {
  double misses = 0, doubles = 0;
};

PerMillion rates(const ClosedSphere& mesh, const std::vector<AimedRay>& rays, const Hits& test) {
  double misses = 0, doubles = 0;
  for (const AimedRay& ray : rays) {
    int hits = 0;
    for (const std::uint32_t triangle : ray.candidates) hits += test(ray, mesh.triangle(triangle)) ? 1 : 0;
    misses += hits == 0 ? 1 : 0;
    doubles += hits > 1 ? 1 : 0;
  }
  const double scale = 1e6 / static_cast<double>(rays.size());
  return {misses * scale, doubles * scale};
}

bool watertight(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const auto result = triangle_watertight(ray.origin, Shear<float>(ray.direction), triangle, TriangleGuard::none);
  return result.verdict == TriangleVerdict::inside && result.t > 0;
}

template <class Real>
Hits moeller_trumbore(Real epsilon, Real tolerance) {
  return [=](const AimedRay& ray, const TracedTriangle<float>& t) {
    const TracedTriangle<Real> triangle{Vec3<Real>(t.a), Vec3<Real>(t.b), Vec3<Real>(t.c), -1};
    const auto result = triangle_moeller_trumbore(Vec3<Real>(ray.origin), Vec3<Real>(ray.direction), triangle, epsilon);
    if (result.verdict == TriangleVerdict::parallel || !(result.t > 0)) return false;
    return result.weights[0] >= -tolerance && result.weights[1] >= -tolerance && result.weights[2] >= -tolerance;
  };
}

/// The watertight test as a compiler contracts it: a b - c d with one product that is not rounded.
bool contracted(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const Shear<float> shear(ray.direction);
  const auto sheared = [&](const Vec3f& corner) {
    const Vec3f p = corner - ray.origin;
    return Vec2f(std::fma(-shear.x, p[shear.kz], p[shear.kx]), std::fma(-shear.y, p[shear.kz], p[shear.ky]));
  };
  const auto difference = [](float p, float q, float r, float s) { return std::fma(p, q, -(r * s)); };
  const Vec2f a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
  const float u = difference(c.x, b.y, c.y, b.x);
  const float v = difference(a.x, c.y, a.y, c.x);
  const float w = difference(b.x, a.y, b.y, a.x);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Side of the ray's line on which each edge passes, by Pluecker coordinates.
bool pluecker(const AimedRay& ray, const TracedTriangle<float>& triangle) {
  const Vec3f a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
  const auto side = [&](const Vec3f& p, const Vec3f& q) { return dot(cross(p - q, p + q), ray.direction); };
  const float u = side(c, b), v = side(a, c), w = side(b, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Within a factor of 1.5 of the rate measured elsewhere, as far as `rays` rays can tell: three standard deviations of
/// our own count more or less.
void expect_rate(double actual, double elsewhere, std::size_t rays, const char* what) {
  const double noise = 3 * std::sqrt(std::max(actual, elsewhere) * 1e6 / static_cast<double>(rays));
  EXPECT_LE(actual, elsewhere * 1.5 + noise) << what;
  EXPECT_GE(actual, elsewhere / 1.5 - noise) << what;
}

constexpr int ray_count = 200'000;

class WatertightRates : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    mesh_ = new ClosedSphere(test::closed_sphere(160, 320, 2, {0, 0, 0}));
    Aim aim(*mesh_);
    edges_ = new std::vector<AimedRay>(aim.many(&Aim::at_edge, ray_count));
    vertices_ = new std::vector<AimedRay>(aim.many(&Aim::at_vertex, ray_count));
  }
  static void TearDownTestSuite() {
    delete mesh_;
    delete edges_;
    delete vertices_;
  }
  static PerMillion at_edges(const char* name, const Hits& test) { return print(name, "edges", *edges_, test); }
  static PerMillion at_vertices(const char* name, const Hits& test) {
    return print(name, "vertices", *vertices_, test);
  }

 private:
  static PerMillion print(const char* name, const char* where, const std::vector<AimedRay>& rays, const Hits& test) {
    const PerMillion result = rates(*mesh_, rays, test);
    std::cout << name << ", " << where << ": " << result.misses << " misses, " << result.doubles
              << " double hits per million (seed " << seed << ")\n";
    return result;
  }
  static inline const ClosedSphere* mesh_ = nullptr;
  static inline const std::vector<AimedRay>* edges_ = nullptr;
  static inline const std::vector<AimedRay>* vertices_ = nullptr;
};

TEST_F(WatertightRates, TheWatertightTestLosesNone) {
  const PerMillion edges = at_edges("watertight", watertight);
  EXPECT_EQ(edges.misses, 0);
  expect_rate(edges.doubles, 26, ray_count, "double hits");
  EXPECT_EQ(at_vertices("watertight", watertight).misses, 0);
}

TEST_F(WatertightRates, MoellerTrumboreLosesOneInTen) {
  expect_rate(at_edges("Moeller-Trumbore", moeller_trumbore<float>(0, 0)).misses, 106'950, ray_count, "edges");
  expect_rate(at_vertices("Moeller-Trumbore", moeller_trumbore<float>(0, 0)).misses, 120'640, ray_count, "vertices");
  // CGPP 15.4.3 prints 1e-7 for the determinant and -1e-10 for the weights.
  expect_rate(at_edges("CGPP's epsilons", moeller_trumbore<float>(1e-7f, 1e-10f)).misses, 107'551, ray_count, "edges");
}

TEST_F(WatertightRates, ToleranceTradesMissesForDoubleHits) {
  const PerMillion small = at_edges("tolerance 1e-6", moeller_trumbore<float>(0, 1e-6f));
  expect_rate(small.misses, 53'817, ray_count, "misses");
  expect_rate(small.doubles, 448'651, ray_count, "double hits");
  const PerMillion middle = at_edges("tolerance 1e-5", moeller_trumbore<float>(0, 1e-5f));
  expect_rate(middle.misses, 2'617, ray_count, "misses");
  expect_rate(middle.doubles, 957'123, ray_count, "double hits");
  const PerMillion large = at_edges("tolerance 1e-4", moeller_trumbore<float>(0, 1e-4f));
  expect_rate(large.misses, 12, ray_count, "misses");
  expect_rate(large.doubles, 998'707, ray_count, "double hits");
}

TEST_F(WatertightRates, DoubleDoesNotMakeVerticesTight) {
  EXPECT_EQ(at_edges("Moeller-Trumbore in double", moeller_trumbore<double>(0, 0)).misses, 0);
  expect_rate(at_vertices("Moeller-Trumbore in double", moeller_trumbore<double>(0, 0)).misses, 4'942, ray_count,
              "vertices");
}

TEST_F(WatertightRates, PlueckerCoordinatesAreTightAtEdgesAlone) {
  EXPECT_EQ(at_edges("Pluecker", pluecker).misses, 0);
  expect_rate(at_vertices("Pluecker", pluecker).misses, 4'482, ray_count, "vertices");
}

TEST_F(WatertightRates, ContractionBreaksTheWatertightTest) {
  expect_rate(at_edges("watertight, contracted", contracted).misses, 488, ray_count, "edges");
}

constexpr int rings = 160, segments = 320;

/// Rays of length 1 from the middle towards random places on a sphere of radius `radius`; percentage that escapes.
double escaped(double radius, const Hits& test) {
  const ClosedSphere mesh = test::closed_sphere(rings, segments, radius, {0, 0, 0});
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  constexpr int rays = 20'000;
  int misses = 0;
  for (int i = 0; i < rays; ++i) {
    // Aimed at the inside of one triangle, chosen by area, so that a single test decides.
    const double polar = std::acos(1 - 2 * unit());
    const auto ring = std::min<std::size_t>(static_cast<std::size_t>(polar / std::numbers::pi * rings), rings - 1);
    const auto first = ring == 0 ? 0 : segments + (ring - 1) * 2 * segments;
    const auto count = static_cast<std::size_t>(ring == 0 || ring == rings - 1 ? segments : 2 * segments);
    const TracedTriangle<float> triangle = mesh.triangle(first + random() % count);
    double p = unit(), q = unit();
    if (p + q > 1) p = 1 - p, q = 1 - q;
    const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
    const Vec3d target = a + (b - a) * (0.1 + 0.7 * p) + (c - a) * (0.1 + 0.7 * q);
    misses += test({Vec3f(0), Vec3f(target / std::sqrt(dot(target, target))), {}}, triangle) ? 0 : 1;
  }
  return 100.0 * misses / rays;
}

/// What an absolute bound on the determinant must lose, in percent: seen from the middle a determinant is twice the
/// triangle's area, r^2 sin(polar) times the two steps between the corners, so the caps around the poles are lost that
/// lie within `polar`. A ring is lost as a whole or not at all.
struct Caps {
  double least = 0, most = 0;
};
Caps lost_caps(double radius, double epsilon) {
  constexpr double pi = std::numbers::pi, step = pi / rings;
  const double sine = epsilon / (radius * radius * step * (2 * pi / segments));
  if (sine >= 1) return {100, 100};
  const double polar = std::asin(sine);
  const auto share = [](double angle) { return 100 * (1 - std::cos(std::clamp(angle, 0.0, pi / 2))); };
  return {share(polar - step), share(polar + step)};
}

TEST(DeterminantEpsilon, LosesSmallMeshesThatTheWatertightTestKeeps) {
  for (const double radius : {2.0, 0.05, 0.02, 0.01, 0.001}) {
    const double tight = escaped(radius, watertight);
    EXPECT_EQ(tight, 0);
    for (const float epsilon : {1e-7f, 1e-8f}) {
      const double lost = escaped(radius, moeller_trumbore<float>(epsilon, 1e-10f));
      const Caps caps = lost_caps(radius, static_cast<double>(epsilon));
      std::cout << "radius " << radius << ": epsilon " << epsilon << " loses " << lost << " %, by area " << caps.least
                << " to " << caps.most << " %, none " << tight << " %\n";
      const double error = 300 * std::sqrt((lost + 0.05) / 100 / 20'000);  // three standard deviations
      EXPECT_GE(lost, caps.least - error);
      EXPECT_LE(lost, caps.most + error);
    }
  }
}

}  // namespace
}  // namespace watertight_rates_test
