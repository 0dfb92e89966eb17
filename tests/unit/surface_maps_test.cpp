// Maps of highlights, ambient light, opacity and reflections, in OBJ models and scene files: known texels against the
// equations worked out by hand, and both renderers against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "frame/fast_kernels.h"
#include "obj_corpus.h"
#include "options/option.h"
#include "render/fast_path.h"
#include "render/left_out.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "shade/reflection_map.h"
#include "support/render_once.h"

namespace ps::surface_maps_test {
namespace {

constexpr int width = 40, height = 20;

/// A rectangle as large as the viewport at z = 2, u to the right and v down, of the material `m`.
Scene wall(const test::ModelFolder& folder, const std::string& material, const std::string& textures) {
  return parse_scene("viewport_size = 2 x 1\nprojection_plane_d = 1\nbackground = linear (0, 0, 1)\n" + textures +
                         "\nmaterial { name = m  " + material +
                         " }\n"
                         "model { name = wall  material = m\n"
                         "  vertices = [(-2, -1, 2), (-2, 1, 2), (2, 1, 2), (2, -1, 2)]\n"
                         "  uvs = [(0, 1), (0, 0), (1, 0), (1, 1)]\n"
                         "  triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] } 1 = { vertices = [0, 2, 3] uvs = "
                         "[0, 2, 3] } } }\n"
                         "instance { model = wall }\n",
                     "wall.scene", folder.path().string());
}

Scene with_lights(Scene scene, std::vector<Light> lights) {
  scene.lights = Part<std::vector<Light>>(std::move(lights));
  return scene;
}

Light ambient_light(double intensity) {
  Light light;
  light.intensity = intensity;
  return light;
}

/// From the camera towards the wall: N = -z, so L = -z lights it straight, and the mirrored light runs along -z.
Light frontal_light(double intensity) {
  Light light;
  light.kind = LightKind::directional;
  light.intensity = intensity;
  light.direction = {0, 0, -1};
  return light;
}

Frame draw(const Scene& scene, const std::string& assignments) {
  Settings settings;
  settings.texture_filter = TextureFilter::nearest;
  parse_assignments(assignments, settings);
  return render(scene, {scene.camera, width, height}, settings);
}

/// The ray tracer, and the rasterizer on each path that it has.
const std::vector<std::string> ways{"renderer=ray-tracer",
                                    "renderer=ray-tracer;simd=off",
                                    "renderer=rasterizer",
                                    "renderer=rasterizer;simd=off",
                                    "renderer=rasterizer;light-passes=many",
                                    "renderer=rasterizer;early-depth=on",
                                    "renderer=rasterizer;deferred-shading=on"};

/// Each pixel's colour must be what `expected(x, y)` gives for its centre in units of the canvas.
void expect_everywhere(const Scene& scene, const std::vector<std::string>& all, const auto& expected) {
  for (const std::string& way : all) {
    const Frame frame = draw(scene, way);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Vec3d want = expected((x + 0.5) / width, (y + 0.5) / height);
        for (int i = 0; i < 3; ++i)
          ASSERT_NEAR(frame.colour.at(x, y)[i], want[i], 2e-5) << way << " at " << x << ", " << y << " channel " << i;
      }
  }
}

// Two texels side by side: the left one half as bright in red, the right one only green.
constexpr const char* two_texels = "P3 2 1 100 50 100 100  0 100 0\n";
bool is_left(double u) { return u < 0.5; }

TEST(SurfaceMaps, AmbientMapMultipliesTheColourOfAmbientLight) {
  const test::ModelFolder folder;
  folder.write("t.ppm", two_texels);
  const std::string texture = "texture { name = t file = t.ppm }";
  const Scene scene =
      with_lights(wall(folder, "color = linear (1, 1, 1) ambient_color = linear (0.5, 1, 1) ambient_map = t", texture),
                  {ambient_light(0.5), frontal_light(0.25)});
  // The frontal light is diffuse alone: colour * intensity.
  expect_everywhere(scene, ways, [](double u, double) {
    const Vec3d map = is_left(u) ? Vec3d(0.5, 1, 1) : Vec3d(0, 1, 0);
    return Vec3d(0.5, 1, 1) * map * 0.5 + Vec3d(0.25);
  });
}

TEST(SurfaceMaps, SpecularMapMultipliesTheHighlight) {
  const test::ModelFolder folder;
  folder.write("t.ppm", two_texels);
  const Scene scene =
      with_lights(wall(folder, "color = black specular = 3 specular_map = t", "texture { name = t file = t.ppm }"),
                  {frontal_light(0.5)});
  // R = (0, 0, -1); V points from (x, y, 2) to the origin, so cos = 2 / length, to the third power.
  expect_everywhere(scene, ways, [](double u, double v) {
    const double x = 4 * u - 2, y = 1 - 2 * v;
    const double highlight = 0.5 * std::pow(2 / std::sqrt(x * x + y * y + 4), 3);
    return (is_left(u) ? Vec3d(0.5, 1, 1) : Vec3d(0, 1, 0)) * highlight;
  });
}

TEST(SurfaceMaps, OpacityMapLetsRaysThroughAndCutsFragmentsOut) {
  const test::ModelFolder folder;
  folder.write("cut.pgm", "P2 2 1 255 255 0\n");
  folder.write("half.pgm", "P2 1 1 4 1\n");
  const Scene cut = with_lights(wall(folder, "color = red opacity_map = t", "texture { name = t file = cut.pgm }"),
                                {ambient_light(1)});
  auto all = ways;
  all.push_back("renderer=rasterizer;visibility=painter");
  all.push_back("renderer=rasterizer;multisampling=4");
  expect_everywhere(cut, all, [](double u, double) { return is_left(u) ? Vec3d(1, 0, 0) : Vec3d(0, 0, 1); });
  // A quarter of the surface and three quarters of what is behind.
  const Scene glass = with_lights(wall(folder, "color = red opacity_map = t", "texture { name = t file = half.pgm }"),
                                  {ambient_light(1)});
  expect_everywhere(glass, {ways[0], ways[1]}, [](double, double) { return Vec3d(0.25, 0, 0.75); });
}

// What is cut out leaves no depth behind either: a second wall, drawn after the first, is seen through its holes.
TEST(SurfaceMaps, CutOutFragmentsHideNothing) {
  const test::ModelFolder folder;
  folder.write("cut.pgm", "P2 2 1 255 255 0\n");
  Scene scene = wall(folder, "color = red opacity_map = t",
                     "texture { name = t file = cut.pgm }\nmaterial { name = b color = green }\n"
                     "model { name = behind material = b vertices = [(-4, -2, 3), (-4, 2, 3), (4, 2, 3), (4, -2, 3)]\n"
                     "  triangles { 0 = (0, 1, 2) 1 = (0, 2, 3) } }\n");
  Object behind = scene.geometry->objects.at(0);
  std::get<Instance>(behind.shape).mesh = 0;
  Geometry geometry = *scene.geometry;
  ASSERT_EQ(geometry.meshes.at(0)->name, "behind");
  geometry.objects.push_back(behind);
  scene.geometry = Part<Geometry>(std::move(geometry));
  auto all = ways;
  all.push_back("renderer=rasterizer;multisampling=4");
  all.push_back("renderer=rasterizer;multisampling=4;depth-reversed=on;depth-format=unorm");
  expect_everywhere(with_lights(scene, {ambient_light(1)}), all,
                    [](double u, double) { return is_left(u) ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0); });
}

// As all that is transparent: a panel beside the view, between the light and the middle of the wall.
TEST(SurfaceMaps, WhatHasAnOpacityMapCastsNoShadow) {
  const test::ModelFolder folder;
  folder.write("t.pgm", "P2 1 1 255 255\n");
  const auto middle = [&](const std::string& map, const std::string& way) {
    const Scene scene = parse_scene(
        "viewport_size = 2 x 1\nprojection_plane_d = 1\ntexture { name = t file = t.pgm }\n"
        "material { name = m " +
            map +
            " }\n"
            "model { name = panel material = m vertices = [(-4, -1, 2), (-4, 1, 2), (-2.2, 1, 2), (-2.2, -1, 2)]\n"
            "  uvs = [(0, 1), (0, 0), (1, 0), (1, 1)]\n"
            "  triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] } 1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] } } "
            "}\n"
            "instance { model = panel }\n"
            "triangle { vertices = [(-9, -9, 4), (0, 20, 4), (9, -9, 4)] color = white }\n"
            "light { type = point intensity = 1 position = (-6, 0, 0) }\n",
        "panel.scene", folder.path().string());
    return draw(scene, way).colour.at(width / 2, height / 2).x;
  };
  for (const std::string way : {"renderer=ray-tracer", "renderer=rasterizer;shadows=map"}) {
    EXPECT_EQ(middle("", way), 0) << way;
    EXPECT_GT(middle("opacity_map = t", way), 0.3f) << way;
  }
}

TEST(SurfaceMaps, TexturesOffLeavesThemOut) {
  const test::ModelFolder folder;
  folder.write("t.pgm", "P2 1 1 255 0\n");
  const Scene scene =
      with_lights(wall(folder, "color = red opacity_map = t", "texture { name = t file = t.pgm }"), {ambient_light(1)});
  expect_everywhere(scene, {"renderer=ray-tracer;textures=off", "renderer=rasterizer;textures=off"},
                    [](double, double) { return Vec3d(1, 0, 0); });
}

// ---- Reflections
// -----------------------------------------------------------------------------------------------------

/// Six faces of one texel, in the order -x, +x, -y, +y, -z, +z.
const std::array<Vec3d, 6> face_colours{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(1, 1, 0),
                                        Vec3d(0, 1, 1), Vec3d(1, 0, 1), Vec3d(1, 1, 1)};
std::string cube_texture(const test::ModelFolder& folder) {
  std::string list;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec3d& c = face_colours[i];
    const std::string name = "f" + std::to_string(i) + ".ppm";
    folder.write(name, "P3 1 1 1 " + std::to_string(int(c.x)) + " " + std::to_string(int(c.y)) + " " +
                           std::to_string(int(c.z)) + "\n");
    list += (i > 0 ? ", " : "") + name;
  }
  return "texture { name = sky cube = [" + list + "] }";
}

TEST(SurfaceMaps, CubeOfPicturesIsReflectedFaceByFace) {
  const test::ModelFolder folder;
  const Scene scene = with_lights(
      wall(folder, "color = black reflective = 0.5 reflection_map = sky surroundings = cube", cube_texture(folder)),
      {ambient_light(1)});
  // The wall z = 2 mirrors the ray (x, y, 1) to (x, y, -1); |x| goes up to 1, so -z is met but for nothing else.
  expect_everywhere(scene, ways, [](double, double) { return 0.5 * face_colours[4]; });
  Scene turned = scene;
  turned.camera.position.z = 1.5;  // the wall is 0.5 away, and fills x / z up to 4
  turned.camera.viewport_width = 8;
  turned.camera.viewport_height = 0.5;
  for (const std::string& way : ways) {
    const Frame frame = draw(turned, way + ";viewport-fit=stretch;near=0.1");
    // Seven pixels from the middle x / z is 1.4 or 1.5, so the mirrored ray goes through a side of the cube.
    EXPECT_EQ(frame.colour.at(width / 2 - 7, height / 2), Vec3f(0.5f * Vec3f(face_colours[0]))) << way;
    EXPECT_EQ(frame.colour.at(width / 2 + 7, height / 2), Vec3f(0.5f * Vec3f(face_colours[1]))) << way;
    EXPECT_EQ(frame.colour.at(width / 2, height / 2), Vec3f(0.5f * Vec3f(face_colours[4]))) << way;
  }
}

// Brute force: every direction through a cube's face meets the texel that a flat picture on that side shows, as seen
// from the inside by somebody who looks to -z with x to the right.
TEST(SurfaceMaps, CubeFacesAreUprightFromTheInside) {
  constexpr int cell = 16;
  struct Side {
    Vec3d forward, right, up;
    int column, row;  // of its cell in the cross
  };
  const Side sides[] = {{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1, 1},  {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2, 1},
                        {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0, 1}, {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}, 3, 1},
                        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 1, 0},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}, 1, 2}};
  for (const Side& side : sides)
    for (int y = 0; y < cell; ++y)
      for (int x = 0; x < cell; ++x) {
        const double a = 2 * (x + 0.5) / cell - 1, b = 1 - 2 * (y + 0.5) / cell;
        const Vec2d uv =
            reflection_uv(Surroundings::cube, (side.forward + side.right * a + side.up * b) * 3.0, 4 * cell, 3 * cell);
        EXPECT_EQ(static_cast<int>(std::floor(uv.x * 4 * cell)), side.column * cell + x);
        EXPECT_EQ(static_cast<int>(std::floor(uv.y * 3 * cell)), side.row * cell + y);
      }
}

TEST(SurfaceMaps, APictureTooSmallForACrossIsReadAllTheSame) {
  const Vec2d uv = reflection_uv(Surroundings::cube, Vec3d(0.3, 0.2, -1), 1, 1);
  EXPECT_EQ(uv, Vec2d(1.5 / 4, 1.5 / 3)) << "the middle of the front";
}

TEST(SurfaceMaps, WorldOfPicturesIsReflected) {
  const test::ModelFolder folder;
  folder.write("sky.ppm", "P3 1 2 1 1 0 0  0 1 0\n");
  const Scene scene = with_lights(
      wall(folder, "color = black reflective = 1 reflection_map = sky", "texture { name = sky file = sky.ppm }"),
      {ambient_light(1)});
  expect_everywhere(scene, ways, [](double, double v) { return v < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0); });
  expect_everywhere(scene, {"renderer=ray-tracer;reflection-depth=0", "renderer=rasterizer;reflection-depth=0"},
                    [](double, double) { return Vec3d(0); });
}

// ---- What the inspector and the fast paths say
// -----------------------------------------------------------------------

TEST(SurfaceMaps, EventsNameTheUseAndTheTexel) {
  const test::ModelFolder folder;
  folder.write("t.ppm", two_texels);
  folder.write("cut.pgm", "P2 2 1 255 255 0\n");
  const Scene scene =
      with_lights(wall(folder, "color = black specular = 3 specular_map = t ambient_map = t opacity_map = c",
                       "texture { name = t file = t.ppm } texture { name = c file = cut.pgm }"),
                  {ambient_light(0.5), frontal_light(0.5)});
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Settings settings{.renderer = renderer};
    settings.texture_filter = TextureFilter::nearest;
    const View view{scene.camera, width, height};
    const auto uses = [&](Vec2i pixel) {
      std::map<TextureUse, Vec3d> found;
      for (const Event& event : inspect(scene, view, settings, pixel).events)
        if (const auto* read = std::get_if<TextureEvent>(&event.data)) found[read->use] = read->result;
      return found;
    };
    const auto left = uses({5, 5});
    EXPECT_EQ(left.at(TextureUse::highlight), Vec3d(0.5, 1, 1));
    EXPECT_EQ(left.at(TextureUse::ambient), Vec3d(0.5, 1, 1));
    EXPECT_EQ(left.at(TextureUse::opacity), Vec3d(1));
    EXPECT_EQ(uses({35, 5}).at(TextureUse::opacity), Vec3d(0));
    if (renderer == Renderer::rasterizer) {
      const PixelStory story = inspect(scene, view, settings, {35, 5});
      EXPECT_NE(story.verdict.find("1 triangle cut out by an opacity map"), std::string::npos) << story.verdict;
    }
  }
}

TEST(SurfaceMaps, TheLedgerNamesThePictureThatIsReflected) {
  const test::ModelFolder folder;
  folder.write("sky.ppm", "P3 1 2 1 1 0 0  0 1 0\n");
  for (const std::string material : {"reflective = 0.25", "reflective = 0.25 reflection_map = sky",
                                     "reflective = 0.25 reflection_map = sky transparency = 0.5"}) {
    const Scene scene = with_lights(wall(folder, "color = red " + material, "texture { name = sky file = sky.ppm }"),
                                    {ambient_light(1)});
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
      Settings settings{.renderer = renderer};
      settings.environment = Environment::cube_map;
      const PixelStory story = inspect(scene, {scene.camera, width, height}, settings, {5, 5});
      std::string terms;
      for (const LedgerLine& line : story.ledger) terms += line.term + "\n";
      const bool pictured = material.find("sky") != std::string::npos;
      EXPECT_EQ(terms.find(" x colour from its reflection map sky") != std::string::npos, pictured) << terms;
      const char* other = renderer == Renderer::ray_tracer ? " x reflected colour" : " x colour from its cube map";
      EXPECT_EQ(terms.find(other) != std::string::npos, !pictured) << terms;
    }
  }
}

TEST(SurfaceMaps, FastPathsDeclineWithTheirReason) {
  Settings settings{.renderer = Renderer::rasterizer};
  SceneTraits traits;
  traits.triangles = traits.textures = true;
  if (!no_simd_reason(settings).empty()) GTEST_SKIP() << no_simd_reason(settings);
  const auto reason = [&](bool SceneTraits::*flag) {
    SceneTraits with = traits;
    with.*flag = true;
    return std::string(fast_path(settings, with, Channel::none).reason);
  };
  EXPECT_EQ(reason(&SceneTraits::opacity_maps), "SIMD cuts nothing out by opacity maps");
  EXPECT_EQ(reason(&SceneTraits::reflection_maps), "SIMD does not support reflection maps");
  settings.shading = Shading::gouraud;
  traits.light_maps = true;
  traits.light_count = traits.shining_lights = 1;
  EXPECT_EQ(left_out_words(traits, settings), "; the rasterizer leaves out specular maps");
}

// ---- Clamping and placing
// --------------------------------------------------------------------------------------------

TEST(SurfaceMaps, AClampedTextureDoesNotRepeat) {
  const test::ModelFolder folder;
  folder.write("t.ppm", "P3 2 1 1 1 0 0  0 1 0\n");
  const Scene scene = parse_scene(
      "viewport_size = 2 x 1\nprojection_plane_d = 1\ntexture { name = t file = t.ppm clamp = on }\n"
      "texture { name = r file = t.ppm }\nmaterial { name = m texture = t }\nmaterial { name = n texture = r }\n"
      "model { name = wall  materials = [m, n]\n"
      "  vertices = [(-2, -1, 2), (-2, 0, 2), (2, 0, 2), (2, -1, 2), (-2, 1, 2), (2, 1, 2)]\n"
      "  uvs = [(-1, 1), (-1, 0), (2, 0), (2, 1)]\n"
      "  triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] material = m }\n"
      "    1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] material = m }\n"
      "    2 = { vertices = [1, 4, 5] uvs = [0, 1, 2] material = n }\n"
      "    3 = { vertices = [1, 5, 2] uvs = [0, 2, 3] material = n } } }\n"
      "instance { model = wall }\nlight { type = ambient intensity = 1 }\n",
      "clamped.scene", folder.path().string());
  auto all = ways;
  all.push_back("renderer=rasterizer;texture-filter=nearest;precision=double");
  expect_everywhere(scene, all, [](double u, double v) {
    const double across = 3 * u - 1;
    const double inside = v > 0.5 ? std::clamp(across, 0.0, 0.999) : across - std::floor(across);
    return inside < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  });
}

/// A quad of the OBJ's material `a` with (u, v) of its corners from 0 to 1, v up.
Scene obj_quad(const test::ModelFolder& folder, const std::string& mtl) {
  folder.write("a.mtl", "newmtl a\n" + mtl);
  return folder.load(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0 7\nvt 1 0 7\nvt 1 1 7\nvt 0 1 7\nusemtl a\n"
      "f 1/1 2/2 3/3 4/4\n");
}

TEST(SurfaceMaps, ScaleAndOffsetMoveTextureCoordinates) {
  const test::ModelFolder folder;
  folder.write("t.ppm", two_texels);
  const Scene scene = obj_quad(folder, "map_Kd -s 2 3 1 -o 0.25 0.5 9 t.ppm\nmap_Ks -s 2 3 -o 0.25 0.5 t.ppm\n");
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
  const Mesh& mesh = test::mesh_of(scene);
  for (const MeshTriangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& corner = mesh.positions[triangle.position[k]];  // u = x, v = y from the bottom
      const Vec2d& uv = mesh.uvs[static_cast<std::size_t>(triangle.uv[k])];
      EXPECT_DOUBLE_EQ(uv.x, 2 * corner.x + 0.25);
      EXPECT_DOUBLE_EQ(1 - uv.y, 3 * corner.y + 0.5);
    }
  const Scene other = obj_quad(folder, "map_Kd -s 2 2 t.ppm\nmap_Ks t.ppm\n");
  ASSERT_EQ(other.warnings.size(), 1U);
  EXPECT_NE(other.warnings[0].find("a.mtl:3: the options -s and -o"), std::string::npos) << other.warnings[0];
}

TEST(SurfaceMaps, ObjNamesThemAll) {
  const test::ModelFolder folder;
  folder.write("t.ppm", two_texels);
  folder.write("g.pgm", "P2 2 1 4 1 3\n");
  std::string faces;
  for (const std::string face : {"top", "bottom", "front", "back", "left", "right"})
    faces += "refl -type cube_" + face + " " + face + ".ppm\n";
  int level = 0;
  for (const std::string face : {"left", "right", "bottom", "top", "front", "back"})
    folder.write(face + ".ppm", "P2 1 1 6 " + std::to_string(++level) + "\n");
  const Scene scene = obj_quad(folder, "Ks 0.5 0.5 0.5\nNs 5\nmap_Ks -mm 0.25 0.5 t.ppm\nmap_Ka t.ppm\nKa 0.5 1 1\n"
                                       "map_d -clamp on g.pgm\n" +
                                           faces + "map_Kd -t 1 1 1 t.ppm\n");
  ASSERT_EQ(scene.warnings.size(), 1U) << scene.warnings[0];
  EXPECT_NE(scene.warnings[0].find("the option -t of map_Kd is not drawn"), std::string::npos);
  const Material& material = material_of(scene, 0, 0);
  const auto texture = [&](int index) -> const Texture& { return scene.textures->at(static_cast<std::size_t>(index)); };
  EXPECT_EQ(texture(material.specular_map).texels->at(0, 0), Vec3f(0.5f, 0.75f, 0.75f));
  EXPECT_EQ(texture(material.ambient_map).texels->at(0, 0), Vec3f(0.5f, 1, 1));
  EXPECT_EQ(texture(material.opacity_map).texels->at(1, 0), Vec3f(0.75f));
  EXPECT_TRUE(texture(material.opacity_map).clamped);
  EXPECT_EQ(material.surroundings, Surroundings::cube);
  EXPECT_DOUBLE_EQ(material.reflective, 0.5);
  const Image<Vec3f>& cross = *texture(material.reflection_map).texels;
  ASSERT_EQ(cross.width(), 4);
  ASSERT_EQ(cross.height(), 3);
  const std::array<Vec2i, 6> cells{Vec2i{0, 1}, {2, 1}, {1, 2}, {1, 0}, {1, 1}, {3, 1}};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(cross.at(cells[i].x, cells[i].y), Vec3f(static_cast<float>(i + 1) / 6)) << i;
  // What the loader made of it is saved and read again.
  const Scene again = parse_scene(write_scene(scene, folder.path()), "again.scene", folder.path());
  EXPECT_EQ(*again.materials, *scene.materials);
  for (std::size_t i = 0; i < scene.textures->size(); ++i)
    EXPECT_EQ(*again.textures->at(i).texels, *scene.textures->at(i).texels) << i;
}

TEST(SurfaceMaps, OpacityComesFromAlphaOrGrey) {
  const test::ModelFolder folder;
  // TGA, 2 x 1 pixels of blue, green, red, alpha: white with alpha 51 and 255.
  std::string tga(18, '\0');
  tga[2] = 2, tga[12] = 2, tga[14] = 1, tga[16] = 32, tga[17] = 8;
  folder.write("alpha.tga", tga + "\xff\xff\xff\x33\xff\xff\xff\xff");
  folder.write("grey.pgm", "P2 2 1 5 1 5\n");
  const auto first = [&](const std::string& options) {
    const Scene scene = obj_quad(folder, "map_d " + options + "\n");
    return scene.textures->at(0).texels->at(0, 0).x;
  };
  EXPECT_FLOAT_EQ(first("alpha.tga"), 0.2f);
  EXPECT_FLOAT_EQ(first("grey.pgm"), 0.2f);
  EXPECT_FLOAT_EQ(first("-imfchan l alpha.tga"), 1.0f);
  EXPECT_FLOAT_EQ(first("-imfchan m grey.pgm"), 1.0f);
  const Scene turned = obj_quad(folder, "map_Tr grey.pgm\n");
  EXPECT_FLOAT_EQ(turned.textures->at(0).texels->at(0, 0).x, 0.8f) << "transparency is the opposite of opacity";
}

}  // namespace
}  // namespace ps::surface_maps_test
