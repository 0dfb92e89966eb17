#include "raytrace/clear/triangle_moeller_trumbore.h"
#include "study/stability/support.h"

namespace ps::stability::nan_in_moller_trumbore {
namespace {

/// Moeller-Trumbore as it is often written: every way to miss has its return.
bool rejecting(const Vec3f& origin, const Vec3f& direction, const TracedTriangle<float>& triangle) {
  const Vec3f edge_b = triangle.b - triangle.a, edge_c = triangle.c - triangle.a;
  const Vec3f p = cross(direction, edge_c);
  const float determinant = dot(edge_b, p);
  if (std::abs(determinant) < 1e-12f) return false;
  const Vec3f s = origin - triangle.a, q = cross(s, edge_b);
  const float u = dot(s, p) / determinant;
  if (u < 0 || u > 1) return false;
  const float v = dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return false;
  const float t = dot(edge_c, q) / determinant;
  return !(t <= 0);
}

bool accepting(const Vec3f& origin, const Vec3f& direction, const TracedTriangle<float>& triangle) {
  const auto result = triangle_moeller_trumbore<float>(origin, direction, triangle, 0);
  return result.verdict == TriangleVerdict::inside && result.t > 0;
}

void measure(const StabilityRun&, Rows& rows) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  struct Case {
    const char* name;
    Vec3f direction;
    TracedTriangle<float> triangle;
  };
  const Vec3f ahead(0, 0, 1), a(-1, -1, 5), b(1, -1, 5), c(0, 1, 5), all_nan(nan);
  for (const Case& k :
       {Case{"NaN vertex", ahead, {a, b, {nan, 1, 5}}}, Case{"all NaN", ahead, {all_nan, all_nan, all_nan}},
        Case{"infinite vertex", ahead, {a, b, {0, inf, 5}}}, Case{"NaN direction", {0, 0, nan}, {a, b, c}},
        Case{"coordinates of 1e30", ahead, {a * 1e30f, b * 1e30f, c * 1e30f}},
        Case{"a triangle ahead", ahead, {a, b, c}}, Case{"a point", ahead, {c, c, c}},
        Case{"collinear", ahead, {Vec3f(-1, 0, 5), Vec3f(0, 0, 5), Vec3f(2, 0, 5)}},
        Case{"coordinates of 1e-30", ahead, {a * 1e-30f, b * 1e-30f, c * 1e-30f}},
        Case{"direction 0", Vec3f(0), {a, b, c}}})
    rows.add(0, k.name, rejecting(Vec3f(0), k.direction, k.triangle) ? 1.0 : 0.0,
             accepting(Vec3f(0), k.direction, k.triangle) ? 1.0 : 0.0, "hits");
}

}  // namespace

extern const StabilityExperiment nan_in_moller_trumbore{
    .key = "nan-in-moller-trumbore",
    .place = {Subject::rays, 150},
    .set_up = SetUp::reproduction,
    .title = "NaN in Moeller-Trumbore",
    .keywords = "not a number, Moeller-Trumbore, Möller-Trumbore, ray triangle",
    .knob = "ray and triangle",
    .naive = "if (u < 0 || ...) return miss",
    .robust = "return u >= 0 && ...",
    .explanation = "Every comparison with NaN is false. If the code tests for reasons to miss, none applies and the "
                   "triangle is hit. If it tests for reasons to hit, none applies and the triangle is missed.",
    .safe = "Finite coordinates whose products are finite.",
    .window = nowhere_safe,
    .series =
        {{.names = "*", .title = "hits of what cannot be hit", .unit = "hits"},
         {.names = "a triangle ahead", .title = "hits of a proper triangle", .unit = "hits", .better = Better::higher}},
    .add_rows = measure};

}  // namespace ps::stability::nan_in_moller_trumbore
