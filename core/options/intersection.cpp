#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_traced_spheres(const Settings&, const SceneTraits& t) {
  if (!t.spheres && !t.csg) return "the scene has no spheres";
  return {};
}

Reason needs_traced_triangles(const Settings&, const SceneTraits& t) {
  if (!t.triangles) return "the scene has no triangles";
  return {};
}

Reason needs_moeller_trumbore(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_traced_triangles(s, t)) return reason;
  if (!row_of(s.triangle_test).has_epsilon)
    return needs("triangle-test", TriangleTest::moeller_trumbore).said("no effect: this triangle test has no epsilon");
  return {};
}

/// The search knows the tests that have SIMD kernels.
FastLimit search_knows_tests() {
  FastLimit limit = knows(triangle_search, 40);
  for (const TriangleTestRow& row : triangle_test_rows)
    if (row.simd) limit.known.push_back(static_cast<OptionNumber>(row.test));
  return limit;
}

std::vector<Choice> triangle_test_choices() {
  std::vector<Choice> choices;
  choices.reserve(triangle_test_rows.size());
  for (const TriangleTestRow& row : triangle_test_rows) choices.push_back({row.key, row.label, row.help});
  return choices;
}

}  // namespace

std::vector<Option> intersection_rows() {
  return {
      choice<&Settings::precision>(
          {.key = "precision",
           .label = "Precision",
           .help = {"The arithmetic of the whole renderer.", "IEEE 754; PBR 4th ed. sec. 6.8",
                    "Float needs care near surfaces and far from the origin; double serves as the reference."},
           .keywords = "float, double, single, rounding, overflow, numeric error, IEEE 754",
           .truth = exactly("precision=double"),
           .known_to = {.fast = {knows(any, 10, Precision::float32)},
                        .hardware = lacking("drivers compute in float", Precision::float64)},
           .shown_by = {.experiments = {{"precision"}, {"world-offset-sphere-acne"}, {"triangle-edge-cracks"}},
                        .scenes = {{"lab/far-origin"}}}},
          {{"float", "float (32 bits)", "About 7 digits, as in fast renderers."},
           {"double", "double (64 bits)", "About 16 digits; slower."}}),
      choice<&Settings::sphere_test>(
          {.key = "sphere-test",
           .label = "Sphere test",
           .help = {"How the quadratic equation of a ray and a sphere is solved.",
                    "CGFS ch. 2; Haines et al., Ray Tracing Gems 7",
                    "In float the textbook form loses all digits for a sphere 4,100 radii away: 43 % of its rays hit "
                    "or miss wrongly."},
           .keywords = "ray sphere, quadratic, discriminant, cancellation, intersection",
           .truth = exactly("sphere-test=robust"),
           .acts_for = ActsFor::rays,
           .inactive = needs_traced_spheres,
           .known_to = {.fast = {knows(sphere_packets, 50, SphereTest::robust)}, .hardware = not_asked},
           .shown_by = {.experiments = {{"ray-sphere-cancellation", is_not<&Settings::sphere_test, SphereTest::robust>,
                                         "sphere-test=robust"}},
                        .scenes = {{"cgfs/reflections"}}}},
          {{"robust", "robust", "Discriminant from the remainder vector, roots without cancellation."},
           {"quadratic", "textbook quadratic", "b^2 - 4ac, as in the book."}}),
      choice<&Settings::triangle_test>(
          {.key = "triangle-test",
           .label = "Triangle test",
           .help =
               {"The intersection test of a ray and a triangle.", "CGPP 15.4.3; Woop et al., JCGT 2013",
                "In float Moeller-Trumbore misses one in eight of the rays that are aimed exactly at a shared edge."},
           .keywords = "ray triangle, Moeller-Trumbore, Möller-Trumbore, intersection, watertight, cracks, barycentric",
           .truth = exactly("triangle-test=watertight"),
           .acts_for = ActsFor::rays,
           .inactive = needs_traced_triangles,
           .known_to = {.fast = {search_knows_tests()}, .hardware = not_asked},
           .shown_by = {.experiments = {{"triangle-edge-cracks",
                                         is_not<&Settings::triangle_test, TriangleTest::watertight>,
                                         "triangle-test=watertight"},
                                        {"cracks-in-an-image"},
                                        {"mt-tolerance"},
                                        {"nan-in-moller-trumbore"}},
                        .scenes = {{"cgfs/brick-wall"}}}},
          triangle_test_choices()),
      real<&Settings::triangle_epsilon>(
          {.key = "triangle-epsilon",
           .label = "Triangle epsilon",
           .help = {"Determinants up to this size count as parallel.", "CGPP 15.4.3",
                    "An absolute epsilon makes small triangles vanish."},
           .keywords = "determinant, tolerance, threshold, parallel, small triangles",
           .truth = exactly("triangle-epsilon=0"),
           .acts_for = ActsFor::rays,
           .inactive = needs_moeller_trumbore,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"absolute-det-epsilon",
                                         [](const Settings& s) { return s.triangle_epsilon > 0; },
                                         "triangle-epsilon=0"}},
                        .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}},
          0, 1, OptionScale::logarithmic),
  };
}

}  // namespace ps::rows
