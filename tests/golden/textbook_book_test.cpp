// The textbook listings against pictures made by the book author's own programs (tests/golden/reference).
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "image/display.h"
#include "image/file.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/rotation.h"
#include "support/golden.h"

namespace ps::textbook_book_test {
namespace {

Image<Rgb8> picture(const Scene& scene, const std::vector<std::string>& changes) {
  Settings settings = settings_for(scene);
  parse_assignment("renderer=textbook", settings);
  for (const std::string& change : changes) parse_assignment(change, settings);
  return display_image(render(scene, {scene.camera, 600, 600}, settings).colour_double);
}

std::int64_t differing(const Image<Rgb8>& actual, const Image<Rgb8>& expected) {
  std::int64_t count = 0;
  for (int y = 0; y < actual.height(); ++y)
    for (int x = 0; x < actual.width(); ++x) count += actual.at(x, y) == expected.at(x, y) ? 0 : 1;
  return count;
}

void expect_book_picture(const std::string& name, const Image<Rgb8>& actual) {
  const Image<Rgb8> expected = load_levels(reference_path(name + ".png"));
  std::cout << name << ": " << differing(actual, expected) << " of 360000 pixels differ\n";
  expect_matches("textbook-" + name, actual, expected, {.max_differing_pixels = 50});
}

Scene on_white(const std::string& name) {
  Scene scene = load_scene(name);
  scene.background = {1, 1, 1};
  return scene;
}

TEST(TextbookBook, RayTracers) {
  expect_book_picture("raytracer-01", picture(on_white("cgfs/spheres"), {}));
  expect_book_picture("raytracer-03", picture(on_white("cgfs/lights"), {}));
  expect_book_picture("raytracer-05-r1", picture(load_scene("cgfs/reflections"), {"reflection-depth=1"}));
}

TEST(TextbookBook, LinesAndTriangles) {
  expect_book_picture("raster-02", picture(load_scene("cgfs/lines"), {}));
  expect_book_picture("raster-03", picture(load_scene("cgfs/triangles"), {}));
  expect_book_picture("raster-07", picture(load_scene("cgfs/wireframe"), {}));
}

TEST(TextbookBook, HiddenSurfaces) {
  const Scene scene = load_scene("cgfs/cubes");
  expect_book_picture("raster-10-depth", picture(scene, {}));
  expect_book_picture("raster-10-nodepth", picture(scene, {"visibility=draw-order", "backface-culling=off"}));
  expect_book_picture("raster-10-depth-outlines", picture(scene, {"draw=outlined"}));
  expect_book_picture("raster-10-nodepth-outlines",
                      picture(scene, {"draw=outlined", "visibility=draw-order", "backface-culling=off"}));
}

TEST(TextbookBook, Shading) {
  const Scene scene = load_scene("cgfs/shading");
  expect_book_picture("raster-11-diffuse-flat-tn",
                      picture(scene, {"specular=off", "shading=flat", "normals=triangle"}));
  expect_book_picture("raster-11-diffuse-gouraud-vn", picture(scene, {"specular=off", "shading=gouraud"}));
  expect_book_picture("raster-11-diffuse-phong-vn", picture(scene, {"specular=off", "shading=phong"}));
}

/// Highlights alone, with the bug of the author's program, which takes the view vector from two spaces. Its cure
/// changes 40,482 pixels, counted in that program.
TEST(TextbookBook, Highlights) {
  const Scene scene = load_scene("cgfs/shading");
  for (const std::string shading : {"flat", "gouraud", "phong"}) {
    const std::vector<std::string> alone{"demo-slips=on", "diffuse=off", "shading=" + shading};
    expect_book_picture("raster-11-specular-" + shading + "-vn", picture(scene, alone));
    std::vector<std::string> flat = alone;
    flat.push_back("normals=triangle");
    expect_book_picture("raster-11-specular-" + shading + "-tn", picture(scene, flat));
  }
  const std::int64_t cured = differing(picture(scene, {"demo-slips=on"}), picture(scene, {}));
  EXPECT_LE(std::abs(cured - 40482), 15);
}

/// The crates with a texture at hand in place of their own.
Scene crates_with(Image<Vec3f> texels) {
  Scene scene = load_scene("cgfs/crates");
  scene.textures.edit([&](std::vector<Texture>& textures) {
    textures[0].texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
  });
  return scene;
}

TEST(TextbookBook, Textures) {
  const Scene scene = crates_with(load_image(reference_path("texture-synthetic-600.png")));
  expect_book_picture("raster-12-perspective-synthtex", picture(scene, {"demo-slips=on"}));
}

/// The author's unfinished program for filters: other crates, and the red of four texels, of which the fourth is a
/// wrong one. Its cure moves every border of the pattern.
TEST(TextbookBook, FilteredTextures) {
  Image<Vec3f> red = load_image(reference_path("texture-synthetic-600.png"));
  for (Vec3f& texel : red.pixels()) texel = Vec3f(texel.x);
  Scene scene = crates_with(std::move(red));
  scene.camera = {};
  scene.geometry.edit([](Geometry& geometry) {
    geometry.objects.resize(2);
    const auto place = [&](std::size_t object, const Vec3d& at, double degrees) {
      Transform& transform = std::get<Instance>(geometry.objects[object].shape).transform;
      transform = {};
      transform.translation = at;
      transform.rotation = rotation_about(Axis::y, degrees);
    };
    place(0, {-1, 0, 3}, -15);
    place(1, {5.5, 5, 20}, 45);
  });
  for (const std::string how : {"perspective", "affine"}) {
    const std::vector<std::string> cured{"texture-filter=bilinear", "interpolation=" + how};
    std::vector<std::string> wrong = cured;
    wrong.push_back("demo-slips=on");
    const Image<Rgb8> with_bugs = picture(scene, wrong);
    expect_book_picture("raster-13-" + how + "-synthtex", with_bugs);
    EXPECT_GT(differing(picture(scene, cured), with_bugs), 1000);
  }
}

}  // namespace
}  // namespace ps::textbook_book_test
