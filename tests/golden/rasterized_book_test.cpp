// The rasterizer against pictures made by the book author's own programs (tests/golden/reference). Those fill triangles
// by scanlines with whole corners and both edges drawn, where ours uses exact edges and a fill rule; so pictures are
// compared away from triangle edges, and everything near an edge is left out by a mask made from the scene alone.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "image/display.h"
#include "image/file.h"
#include "raster/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/golden.h"

namespace {

using namespace ps;

Settings book_settings() {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.sample_position = SamplePosition::corner;
  settings.precision = Precision::float64;
  return settings;
}

Image<Rgb8> picture(const Scene& scene, const Settings& settings) {
  Prepared prepared;
  Progress progress;
  return display_image(
      render_rasterized(scene, {scene.camera, 600, 600}, settings, {}, prepared, progress).colour_double);
}

Image<Rgb8> reference(const std::string& name) { return display_image(load_image(reference_path(name + ".png"))); }

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d ab = b - a, ap = p - a;
  const double squared = ab.x * ab.x + ab.y * ab.y;
  const double t = squared > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

/// Marks the pixels whose sample lies within `reach` of a segment, in the book's coordinates.
void mark_near(Image<std::uint8_t>& mask, const Vec2d& a, const Vec2d& b, double reach) {
  const auto low = [&](double p, double q) { return static_cast<int>(std::floor(std::min(p, q) - reach)); };
  const auto high = [&](double p, double q) { return static_cast<int>(std::ceil(std::max(p, q) + reach)); };
  for (int y = std::max(low(a.y, b.y), -300); y <= std::min(high(a.y, b.y), 299); ++y)
    for (int x = std::max(low(a.x, b.x), -300); x <= std::min(high(a.x, b.x), 299); ++x)
      if (distance_to_segment({x, y}, a, b) <= reach) mask.at(x + 300, 299 - y) = 1;
}

enum class MaskFaces { front, all };

/// Edges of the triangles that face the camera, or of all, projected with the book's formula.
Image<std::uint8_t> edge_mask(const Scene& scene, double reach, MaskFaces faces = MaskFaces::front) {
  Image<std::uint8_t> mask(600, 600, 0);
  for (const Object& object : scene.geometry->objects) {
    const auto& instance = std::get<Instance>(object.shape);
    const Mesh& mesh = *scene.geometry->meshes[instance.mesh];
    const Transform& t = instance.transform;
    for (const MeshTriangle& triangle : mesh.triangles) {
      std::array<Vec3d, 3> p;
      std::array<Vec2d, 3> canvas;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d world = t.rotation * (t.scale * mesh.positions[triangle.position[k]]) + t.translation;
        const Vec3d offset = world - scene.camera.position;
        p[k] = {dot(offset, scene.camera.right), dot(offset, scene.camera.up), dot(offset, scene.camera.forward)};
        canvas[k] = {p[k].x * 600 / p[k].z, p[k].y * 600 / p[k].z};
      }
      if (faces == MaskFaces::front && !(dot(-p[0], cross(p[1] - p[0], p[2] - p[0])) > 0)) continue;
      for (std::size_t k = 0; k < 3; ++k) mark_near(mask, canvas[k], canvas[(k + 1) % 3], reach);
    }
  }
  return mask;
}

/// The scene with every corner moved, at its own z, to where the book's programs see it: its place on the canvas loses
/// its fraction. Each instance gets a mesh of its own; normals stay.
Scene with_whole_corners(Scene scene) {
  const Camera camera = scene.camera;
  scene.geometry.edit([&](Geometry& geometry) {
    for (Object& object : geometry.objects) {
      auto& instance = std::get<Instance>(object.shape);
      const Transform& t = instance.transform;
      Mesh mesh = *geometry.meshes[instance.mesh];
      for (Vec3d& position : mesh.positions) {
        const Vec3d offset = t.rotation * (t.scale * position) + t.translation - camera.position;
        const double z = dot(offset, camera.forward);
        const double x = std::trunc(dot(offset, camera.right) * 600 / z) * z / 600;
        const double y = std::trunc(dot(offset, camera.up) * 600 / z) * z / 600;
        const Vec3d world = camera.position + camera.right * x + camera.up * y + camera.forward * z;
        position = glm::inverse(t.rotation) * (world - t.translation) / t.scale;
      }
      instance.mesh = static_cast<std::uint32_t>(geometry.meshes.size());
      geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
    }
  });
  return scene;
}

struct Differences {
  std::int64_t near_edges = 0, elsewhere = 0, compared_elsewhere = 0;
  int largest_elsewhere = 0;
  double mean_elsewhere = 0;  ///< levels, of the largest channel
};

Differences compare(const Image<Rgb8>& actual, const Image<Rgb8>& expected, const Image<std::uint8_t>& mask) {
  Differences result;
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 600; ++x) {
      const Rgb8 a = actual.at(x, y), e = expected.at(x, y);
      const int level = std::max({std::abs(a.r - e.r), std::abs(a.g - e.g), std::abs(a.b - e.b)});
      if (mask.at(x, y)) {
        result.near_edges += level > 0;
      } else {
        ++result.compared_elsewhere;
        result.elsewhere += level > 0;
        result.mean_elsewhere += level;
        result.largest_elsewhere = std::max(result.largest_elsewhere, level);
      }
    }
  result.mean_elsewhere /= static_cast<double>(std::max<std::int64_t>(result.compared_elsewhere, 1));
  return result;
}

Differences report(const std::string& name, const Image<Rgb8>& actual, const Image<std::uint8_t>& mask) {
  const Differences d = compare(actual, reference(name), mask);
  std::cout << name << ": " << d.near_edges << " pixels differ near edges, " << d.elsewhere << " of "
            << d.compared_elsewhere << " elsewhere, by at most " << d.largest_elsewhere << " levels, mean "
            << d.mean_elsewhere << "\n";
  return d;
}

TEST(RasterizedBook, GeneralLines) {
  expect_matches("raster-02", picture(load_scene("cgfs/lines"), book_settings()), reference_path("raster-02.png"));
}

TEST(RasterizedBook, FilledTriangleWithOutline) {
  Image<std::uint8_t> mask(600, 600, 0);
  mark_near(mask, {-200, -250}, {200, 50}, 1.5);
  mark_near(mask, {200, 50}, {20, 250}, 1.5);
  mark_near(mask, {20, 250}, {-200, -250}, 1.5);
  const Differences d = report("raster-03", picture(load_scene("cgfs/triangles"), book_settings()), mask);
  EXPECT_EQ(d.elsewhere, 0);
  EXPECT_LE(d.near_edges, 1200);
}

TEST(RasterizedBook, WireframeCubes) {
  Settings settings = book_settings();
  settings.draw = Draw::wireframe;
  settings.lighting = false;
  settings.backface_culling = false;
  const Image<Rgb8> actual = picture(load_scene("cgfs/wireframe"), settings);
  expect_matches("raster-07", actual, reference_path("raster-07.png"), {.max_differing_pixels = 60, .max_level = 255});
}

TEST(RasterizedBook, HiddenSurfaces) {
  const Scene scene = load_scene("cgfs/cubes");
  Settings settings = book_settings();
  settings.lighting = false;
  const Differences with = report("raster-10-depth", picture(scene, settings), edge_mask(scene, 2));
  EXPECT_EQ(with.elsewhere, 0);

  settings.visibility = Visibility::draw_order;
  settings.backface_culling = false;
  const Image<std::uint8_t> mask = edge_mask(scene, 2, MaskFaces::all);
  const Differences without = report("raster-10-nodepth", picture(scene, settings), mask);
  EXPECT_GT(without.compared_elsewhere, 300000);
  EXPECT_EQ(without.elsewhere, 0);
  // The two pictures differ in whole faces, so neither setting passes for the other.
  EXPECT_GT(report("raster-10-depth", picture(scene, settings), mask).elsewhere, 10000);
}

/// Flat shading equals the book's as the scene is. For the others the corners are moved to whole pixels, as the book's
/// programs do; what stays is their spans, which begin and end at whole columns too but with the values of the true
/// edges, so values inside slide sideways by up to a pixel. Five levels is the steepest change across one pixel of the
/// ball (eight with corners left where they are), and the mean tells the right shading from a wrong one.
TEST(RasterizedBook, Shading) {
  const Scene scene = load_scene("cgfs/shading");
  const Scene whole = with_whole_corners(scene);
  const Image<std::uint8_t> mask = edge_mask(scene, 2);
  const auto draw = [&](const Scene& of, Shading shading, Normals normals) {
    Settings settings = book_settings();
    settings.specular = false;
    settings.shading = shading;
    settings.normals = normals;
    settings.interpolation = Interpolation::affine;
    return picture(of, settings);
  };
  const Image<Rgb8> flat = draw(scene, Shading::flat, Normals::triangle);
  const Image<Rgb8> gouraud = draw(whole, Shading::gouraud, Normals::vertex);
  const Image<Rgb8> phong = draw(whole, Shading::phong, Normals::vertex);
  const Differences flat_flat = report("raster-11-diffuse-flat-tn", flat, mask);
  EXPECT_GT(flat_flat.compared_elsewhere, 300000);
  EXPECT_EQ(flat_flat.elsewhere, 0);
  const Differences gouraud_gouraud = report("raster-11-diffuse-gouraud-vn", gouraud, mask);
  EXPECT_LE(gouraud_gouraud.largest_elsewhere, 5);
  EXPECT_LT(gouraud_gouraud.mean_elsewhere, 0.03);
  const Differences phong_phong = report("raster-11-diffuse-phong-vn", phong, mask);
  EXPECT_LE(phong_phong.largest_elsewhere, 5);
  EXPECT_LT(phong_phong.mean_elsewhere, 0.08);
  EXPECT_GT(report("raster-11-diffuse-phong-vn", draw(scene, Shading::phong, Normals::vertex), mask).mean_elsewhere,
            1.3 * phong_phong.mean_elsewhere);
  EXPECT_GT(report("raster-11-diffuse-phong-vn", gouraud, mask).mean_elsewhere, 2 * phong_phong.mean_elsewhere);
  EXPECT_GT(report("raster-11-diffuse-gouraud-vn", phong, mask).mean_elsewhere, 3 * gouraud_gouraud.mean_elsewhere);
  EXPECT_GT(report("raster-11-diffuse-flat-tn", phong, mask).mean_elsewhere, 0.5);
}

/// In kind only: the book's programs mix up two spaces in the highlight's view vector (up to 63 levels on one pixel in
/// eight), and whole corners move the texture by up to a pixel.
TEST(RasterizedBook, TexturedCubes) {
  Scene scene = load_scene("cgfs/crates");
  scene.textures.edit([](std::vector<Texture>& textures) {
    textures[0].texels = std::make_shared<const Image<Vec3f>>(load_image(reference_path("texture-synthetic-600.png")));
  });
  Settings settings = book_settings();
  settings.texture_filter = TextureFilter::nearest;
  const Image<std::uint8_t> mask = edge_mask(scene, 2);
  const Differences d = report("raster-12-perspective-synthtex", picture(scene, settings), mask);
  settings.interpolation = Interpolation::affine;
  const Differences affine = report("raster-12-perspective-synthtex", picture(scene, settings), mask);
  EXPECT_LT(d.mean_elsewhere, 3);
  EXPECT_GT(affine.mean_elsewhere, 3 * d.mean_elsewhere);
}

}  // namespace
