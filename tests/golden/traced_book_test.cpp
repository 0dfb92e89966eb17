// The ray tracer against pictures made by the book author's own programs (tests/golden/reference).
#include <gtest/gtest.h>

#include <iostream>

#include "image/display.h"
#include "image/file.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/golden.h"

namespace ps::traced_book_test {
namespace {

/// The book's arithmetic: double, its quadratic formula, its epsilon and its pixel corners.
Settings book_settings() {
  Settings settings{.renderer = Renderer::ray_tracer};
  settings.sample_position = SamplePosition::corner;
  settings.precision = Precision::float64;
  settings.sphere_test = SphereTest::quadratic;
  settings.self_hit = SelfHit::epsilon;
  return settings;
}

Image<Rgb8> picture(const Scene& scene, const Settings& settings) {
  View view{scene.camera, 600, 600};
  Prepared prepared;
  Progress progress;
  return display_image(render_traced(scene, view, settings, {}, prepared, progress).colour_double);
}

void expect_book_picture(const std::string& name, const Image<Rgb8>& actual) {
  const Image<Rgb8> expected = display_image(load_image(reference_path(name + ".png")));
  std::int64_t differing = 0;
  for (int y = 0; y < actual.height(); ++y)
    for (int x = 0; x < actual.width(); ++x) differing += actual.at(x, y) == expected.at(x, y) ? 0 : 1;
  std::cout << name << ": " << differing << " of 360000 pixels differ\n";
  expect_matches(name, actual, expected, {.max_differing_pixels = 50, .max_level = 1});
}

TEST(TracedBook, Spheres) {
  Scene scene = load_scene("cgfs/reflections");
  scene.background = {1, 1, 1};
  Settings settings = book_settings();
  settings.lighting = false;
  settings.reflection_depth = 0;
  expect_book_picture("raytracer-01", picture(scene, settings));
}

TEST(TracedBook, DiffuseAndSpecularLight) {
  Scene scene = load_scene("cgfs/reflections");
  scene.background = {1, 1, 1};
  Settings settings = book_settings();
  settings.shadows = Shadows::none;
  settings.reflection_depth = 0;
  expect_book_picture("raytracer-03", picture(scene, settings));
}

TEST(TracedBook, ShadowsAndOneReflection) {
  Settings settings = book_settings();
  settings.reflection_depth = 1;
  expect_book_picture("raytracer-05-r1", picture(load_scene("cgfs/reflections"), settings));
}

}  // namespace
}  // namespace ps::traced_book_test
