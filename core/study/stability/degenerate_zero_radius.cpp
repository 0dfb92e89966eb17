#include <cmath>
#include <utility>

#include "base/check.h"
#include "raytrace/clear/sphere_quadratic.h"
#include "raytrace/clear/triangle_watertight.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::degenerate_zero_radius {
namespace {

/// A textbook sphere test that turns away what it can name: a negative discriminant, a root before t = 0. What is
/// neither is taken for a hit.
bool rejecting(const Vec3f& direction, const TracedSphere<float>& sphere) {
  const Vec3f f = Vec3f(0) - sphere.centre;
  const float a = dot(direction, direction), b = 2 * dot(f, direction);
  const float discriminant = b * b - 4 * a * (dot(f, f) - sphere.radius * sphere.radius);
  if (discriminant < 0) return false;
  const float t = (-b - std::sqrt(discriminant)) / (2 * a);
  return !(t <= 0);
}

/// Where the textbook's formula puts the hit.
double nearest_root(const Vec3f& direction, const TracedSphere<float>& sphere) {
  const auto roots = sphere_quadratic<float>(Vec3f(0), direction, dot(direction, direction), sphere);
  return static_cast<double>(roots.near);
}

/// The first test with the questions turned round: a hit is what passes.
bool accepting(const Vec3f& direction, const TracedSphere<float>& sphere) {
  const auto roots = sphere_quadratic<float>(Vec3f(0), direction, dot(direction, direction), sphere);
  return sphere.radius > 0 && std::isfinite(sphere.radius) && roots.discriminant >= 0 && roots.near > 0 &&
         std::isfinite(roots.near);
}

bool loads(std::string_view radius) {
  try {
    parse_scene("sphere { center = (0, 0, 5) radius = " + std::string(radius) + " color = red }\n", "radius", ".");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  struct Case {
    const char* name;
    Vec3f direction;
    TracedSphere<float> sphere;
  };
  const Vec3f ahead(0, 0, 1);
  Rows rows(run);
  for (const auto& [name, radius] : {std::pair{"radius 0", 0.0f}, {"radius -1", -1.0f}, {"radius infinite", inf}})
    rows.push_back(
        {0, std::string(name) + ", t of the hit", nearest_root(ahead, {{0, 0, 5}, radius}), std::nan(""), "t"});
  for (const Case& c :
       {Case{"radius 0", ahead, {{0, 0, 5}, 0}}, Case{"radius -1", ahead, {{0, 0, 5}, -1}},
        Case{"radius NaN", ahead, {{0, 0, 5}, nan}}, Case{"radius infinite", ahead, {{0, 0, 5}, inf}},
        Case{"direction 0", Vec3f(0), {{0, 0, 5}, 1}}, Case{"centre at 1e20", ahead, {{0, 0, 1e20f}, 1}},
        Case{"centre at 2e19, radius 1e19", ahead, {{0, 0, 2e19f}, 1e19f}},
        Case{"a ball ahead", ahead, {{0, 0, 5}, 1}}})
    rows.push_back({0, c.name, rejecting(c.direction, c.sphere) ? 1.0 : 0.0,
                    accepting(c.direction, c.sphere) ? 1.0 : 0.0, "hits"});
  for (const char* radius : {"0", "-1", "nan", "inf", "1e400"})
    rows.push_back(
        {0, std::string("scene file with radius ") + radius, std::nan(""), loads(radius) ? 1.0 : 0.0, "accepted"});
  return rows;
}

}  // namespace

static constexpr StabilitySeries degenerate_zero_radius_series[]{
    {.names = "*", .title = "hits of a shape without a surface", .unit = "hits"},
    {.names = "a ball ahead", .title = "hits of a proper ball", .unit = "hits", .better = Better::higher},
    {.names = "*t of the hit",
     .title = "place of the hit on the ray",
     .unit = "ray parameter",
     .better = Better::neither},
    {.names = "scene file*", .title = "scene files that are accepted", .unit = "files"},
};

extern const StabilityExperiment degenerate_zero_radius{
    .key = "degenerate-zero-radius",
    .place = {Subject::rays, 160},
    .set_up = SetUp::reproduction,
    .title = "Degenerate shapes",
    .keywords = "zero area, division by zero, NaN, sliver",
    .knob = "shape",
    .naive = "if (bad) return miss",
    .robust = "return good, and refuse bad input when it is read",
    .explanation = "Every comparison with NaN is false. A test that lists reasons to reject a ray finds none and "
                   "reports a hit. A test that lists reasons to accept it finds none either and reports a miss.",
    .safe = "Input that was checked.",
    .window = nowhere_safe,
    .series = degenerate_zero_radius_series,
    .measure = measure};

}  // namespace ps::stability::degenerate_zero_radius
