#include "study/model/model_needs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "frame/display_frame.h"
#include "image/display.h"
#include "image/file.h"
#include "image/metrics.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/obj.h"
#include "scene/scene_file.h"
#include "scene/texture_generator.h"
#include "study/model/model_files.h"
#include "study/model/model_words.h"
#include "study/model/views.h"
#include "study/worst_tile.h"
#include "support/environment.h"
#include "support/run_cli.h"
#include "support/seeded_random.h"
#include "support/trials.h"

namespace ps::model_needs_test {
namespace {

constexpr const char* looks_along_z =
    "canvas_size = 64 x 64\nviewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n";

ModelRequest request_for(Scene scene, int width, int height) {
  ModelRequest request;
  request.views = {{scene.camera, width, height}};
  request.base = settings_for(scene);
  request.scene = std::move(scene);
  return request;
}

ModelRequest request_for(const std::string& text, int width = 64, int height = 64) {
  return request_for(parse_scene(looks_along_z + text, "made.scene", "."), width, height);
}

ModelNeeds needs_of(const ModelRequest& request) {
  StudyControl control;
  return find_model_needs(request, control);
}

const ModelSaving* saving_of(const ModelNeeds& needs, ModelPart part) {
  const auto found = std::find_if(needs.savings.begin(), needs.savings.end(),
                                  [&](const ModelSaving& saving) { return saving.part == part; });
  return found == needs.savings.end() ? nullptr : &*found;
}

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.geometry->objects) names.push_back(object.name);
  return names;
}

Settings with_renderer(Settings settings, PictureWay way) {
  settings.renderer = renderer_for(way);
  return settings;
}

Image<Rgb8> levels_of(const Scene& scene, const View& view, const Settings& settings) {
  return display_frame(render(scene, view, settings), settings);
}

/// The mean of 8 x 8 rays for each pixel, from a picture that is 8 times as wide and high.
Image<Rgb8> mean_of_rays(const Scene& scene, const View& view, const Settings& settings) {
  constexpr int side = 8;
  const Frame frame = render(scene, {view.camera, view.width * side, view.height * side}, settings);
  Image<Vec3d> means(view.width, view.height);
  for (int y = 0; y < view.height * side; ++y)
    for (int x = 0; x < view.width * side; ++x)
      means.at(x / side, y / side) += Vec3d(frame.colour.at(x, y)) / static_cast<double>(side * side);
  return display_image(means, display_transform(settings));
}

// A row of 101 tiles at z = 4, of which the eye sees 4 units. Which of them lie under the centre of a pixel follows
// from the projection alone.
TEST(ModelNeeds, TrianglesThatNoPixelShowsGoAndNoOther) {
  Scene scene =
      parse_scene(std::string(looks_along_z) + "light { type = ambient\n intensity = 1 }\n", "made.scene", ".");
  Mesh mesh;
  mesh.name = "row";
  constexpr int squares = 101;
  std::vector<double> kept;
  for (int i = 0; i < squares; ++i) {
    const double x0 = i - 50.5, x1 = x0 + 0.9;  // with gaps, or else one rectangle would do
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    // Seen from below at z = 4, each square as high as the view, in two triangles along its diagonal.
    for (const Vec3d& corner : {Vec3d{x0, -2, 4}, Vec3d{x1, -2, 4}, Vec3d{x1, 2, 4}, Vec3d{x0, 2, 4}})
      mesh.positions.push_back(corner);
    mesh.triangles.push_back({.position = {first, first + 2, first + 1}});
    mesh.triangles.push_back({.position = {first, first + 3, first + 2}});
    bool seen = false;
    for (int column = 0; column < 64; ++column) {
      const double x = ((column + 0.5) / 64 - 0.5) * 4;
      seen = seen || (x > x0 && x < x1);
    }
    if (seen) kept.push_back(x0);
  }
  mesh.materials = {0};
  scene.materials = Part<std::vector<Material>>(std::vector<Material>(1));
  scene.geometry.edit([&](Geometry& geometry) {
    geometry.meshes = {std::make_shared<const Mesh>(mesh)};
    geometry.objects = {{"row", Instance{}, false}};
  });
  ASSERT_EQ(kept.size(), 5u);
  const ModelNeeds needs = needs_of(request_for(std::move(scene), 64, 64));
  const ModelSaving* saving = saving_of(needs, ModelPart::triangles);
  ASSERT_NE(saving, nullptr);
  ASSERT_EQ(needs.scene.geometry->meshes.size(), 1u);
  const Mesh& left = *needs.scene.geometry->meshes[0];
  EXPECT_EQ(left.triangles.size(), 2 * kept.size());
  for (const Vec3d& corner : left.positions) {
    EXPECT_GE(corner.x, kept.front());
    EXPECT_LE(corner.x, kept.back() + 1);
  }
  EXPECT_EQ(needs.change.increase, 0);
  EXPECT_GT(saving->bytes, 0.9);
}

constexpr const char* two_lights = "light { type = ambient\n intensity = 0.2 }\n"
                                   "light { type = directional\n intensity = 0.6\n direction = (0, 1, -1) }\n";

// The eye looks along z. A mirror at z = 6 shows it what lies behind it.
TEST(ModelNeeds, WhatOnlyAMirrorShowsStays) {
  const ModelRequest request =
      request_for(std::string("light { type = ambient\n intensity = 0.8 }\n") +
                  "rectangle { name = mirror\n corner = (-4, -4, 8)\n side_a = (0, 8, 0)\n side_b = (8, "
                  "0, 0)\n color = (30, 30, 30)\n reflective = 0.9 }\n"
                  "sphere { name = shown\n center = (0, 0, -4)\n radius = 1.5\n color = red }\n"
                  "sphere { name = hidden\n center = (0, 0, 40)\n radius = 1\n color = green }\n");
  const ModelNeeds needs = needs_of(request);
  EXPECT_EQ(names_of(needs.scene), (std::vector<std::string>{"mirror", "shown"}));
  StudyControl control;
  Scene over_reduced = request.scene;
  over_reduced.geometry.edit([](Geometry& geometry) { geometry.objects.erase(geometry.objects.begin() + 1); });
  EXPECT_GT(check_reduction(request, over_reduced, request.base, control).increase, request.tolerance)
      << "the picture by fragments stays, that by rays does not";
  const View& view = request.views.front();
  const Settings fragments = with_renderer(request.base, PictureWay::fragments);
  EXPECT_EQ(levels_of(over_reduced, view, fragments), levels_of(request.scene, view, fragments));
}

TEST(ModelNeeds, AShadowOfAnObjectBehindTheCameraStays) {
  const ModelRequest request = request_for(
      std::string("light { type = ambient\n intensity = 0.2 }\n") +
      "light { type = directional\n intensity = 0.8\n direction = (0, 1, -1) }\n"
      "rectangle { name = floor\n corner = (-9, -1, 0)\n side_a = (0, 0, 20)\n side_b = (18, 0, 0)\n color = white }\n"
      "sphere { name = thrower\n center = (0, 4, -1)\n radius = 1\n color = red }\n"
      "sphere { name = elsewhere\n center = (0, 4, -40)\n radius = 1\n color = red }\n");
  EXPECT_EQ(names_of(needs_of(request).scene), (std::vector<std::string>{"floor", "thrower"}));
}

TEST(ModelNeeds, OfTwelveLightsTheTwoThatMatterStay) {
  test::SeededRandom random;
  std::vector<std::size_t> order(12);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  std::string text = "sphere { name = ball\n center = (0, 0, 4)\n radius = 1\n color = white }\n";
  for (const std::size_t light : order) {
    if (light == 0) text += "light { type = ambient\n intensity = 0.3 }\n";
    if (light == 1) text += "light { type = directional\n intensity = 0.6\n direction = (1, 1, -1) }\n";
    if (light > 1 && light < 7)
      text += "light { type = point\n intensity = 0.6\n position = (0, 0, 9) }\n";  // behind it
    if (light >= 7) text += "light { type = point\n intensity = 0.0005\n position = (2, 2, 0) }\n";
  }
  const ModelNeeds needs = needs_of(request_for(text));
  ASSERT_EQ(needs.scene.lights->size(), 2u);
  for (const Light& light : *needs.scene.lights) EXPECT_NE(light.kind, LightKind::point);
  const ModelSaving* saving = saving_of(needs, ModelPart::lights);
  ASSERT_NE(saving, nullptr);
  EXPECT_EQ(saving->goes, "ten of twelve lights");
  EXPECT_EQ(saving->things.size(), 10u);
}

// 512 texels across 40 pixels: each pixel covers 12.8 of them, so that fragments read levels from log2(12.8) = 3.7 on.
TEST(ModelNeeds, ATextureIsAsFineAsAPixelReadsIt) {
  for (const PictureWay way : {PictureWay::fragments, PictureWay::rays}) {
    ModelRequest request = request_for("light { type = ambient\n intensity = 1 }\n"
                                       "texture { name = bricks\n generator = bricks\n size = 512 }\n"
                                       "rectangle { name = wall\n corner = (-1, -1, 3.2)\n side_a = (0, 2, 0)\n side_b "
                                       "= (2, 0, 0)\n texture = bricks }\n");
    request.base = with_renderer(request.base, way);
    const ModelNeeds needs = needs_of(request);
    ASSERT_EQ(needs.scene.textures->size(), 1u);
    EXPECT_EQ((*needs.scene.textures)[0].texels->width(), 512 >> 3);
    EXPECT_LE(needs.change.increase, request.tolerance);
    StudyControl control;
    Scene over_reduced = needs.scene;
    over_reduced.textures.edit([](std::vector<Texture>& textures) {
      textures[0].texels = std::make_shared<const Image<Vec3f>>(generate_texture("bricks", 2));
    });
    EXPECT_GT(check_reduction(request, over_reduced, request.base, control).increase, request.tolerance);
  }
}

std::string cube_model(bool whole) {
  std::string text = "model { name = cube\n color = red\n vertices {\n";
  for (int i = 0; i < 8; ++i)
    text += std::to_string(i) + " = (" + (i & 1 ? "1" : "-1") + ", " + (i & 2 ? "1" : "-1") + ", " +
            (i & 4 ? "1" : "-1") + ")\n";
  text += "}\n triangles {\n";
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  int number = 0;
  for (int face = 0; face < (whole ? 6 : 5); ++face) {
    const int* f = faces[face];
    for (int k = 1; k < 3; ++k)
      text += std::to_string(number++) + " = " + std::to_string(f[0]) + ", " + std::to_string(f[k]) + ", " +
              std::to_string(f[k + 1]) + "\n";
  }
  return text + "} }\n instance { name = crate\n model = cube\n transform { scale = 0.5\n rotation = <30 degrees "
                "around the Y axis>\n "
                "translation = (0, 0.2, 4) } }\n";
}

TEST(ModelNeeds, ABoxDoesForACubeOfTrianglesAndForNoOpenOne) {
  const ModelNeeds closed = needs_of(request_for(two_lights + cube_model(true)));
  ASSERT_EQ(closed.scene.geometry->objects.size(), 1u);
  const auto* box = std::get_if<Solid>(&closed.scene.geometry->objects[0].shape);
  ASSERT_NE(box, nullptr);
  const auto& brick = std::get<Brick>(box->form);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(brick.size[axis], 1, 1e-9);
    EXPECT_NEAR(brick.centre[axis], (Vec3d{0, 0.2, 4})[axis], 1e-9);
  }
  EXPECT_EQ(saving_of(needs_of(request_for(two_lights + cube_model(false))), ModelPart::shapes), nullptr);
}

TEST(ModelNeeds, WhereNothingCanGoItSaysSo) {
  const ModelNeeds needs = needs_of(request_for(
      std::string(two_lights) + "sphere { name = ball\n center = (0, 0, 4)\n radius = 1\n color = red }\n"));
  EXPECT_TRUE(needs.savings.empty());
  EXPECT_EQ(model_sentence(needs).rfind("Nothing can go", 0), 0u) << model_sentence(needs);
}

// From one view the ball behind the other one goes; from all around it is seen.
TEST(ModelNeeds, ViewsAllAroundKeepWhatOneViewHides) {
  ModelRequest request = request_for(std::string(two_lights) +
                                     "sphere { name = front\n center = (0, 0, 6)\n radius = 1.5\n color = red }\n"
                                     "sphere { name = back\n center = (0, 0, 9)\n radius = 0.5\n color = green }\n");
  EXPECT_EQ(names_of(needs_of(request).scene), (std::vector<std::string>{"front"}));
  StudyControl control;
  request.views = orbit_views(request.scene, request.views.front(), 4, control);
  ASSERT_EQ(request.views.size(), 4u);
  EXPECT_EQ(names_of(needs_of(request).scene), (std::vector<std::string>{"front", "back"}));
}

// A third of the scenes, another one in each run. Drawn and compared here, not by the study.
TEST(ModelNeeds, NoReducedSceneLeavesTheTolerance) {
  const unsigned seed = test::test_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  for (std::size_t i = seed % 3; i < scenes.size(); i += 3 * static_cast<std::size_t>(test::trial_divisor)) {
    SCOPED_TRACE(scenes[i].name);
    const ModelRequest request = request_for(load_scene(scenes[i].name), 64, 48);
    const ModelNeeds needs = needs_of(request);
    EXPECT_LE(needs.bytes, needs.default_bytes);
    const View& view = request.views.front();
    for (const PictureWay way : {PictureWay::rays, PictureWay::fragments}) {
      const Settings full = with_renderer(request.base, way), less = with_renderer(needs.settings, way);
      const Image<Rgb8> before = levels_of(request.scene, view, full), after = levels_of(needs.scene, view, less);
      const bool means = way == PictureWay::rays && saving_of(needs, ModelPart::textures);
      if (!means) {
        EXPECT_LE(worst_tile_flip(before, after), request.tolerance);
        continue;
      }
      const Image<Rgb8> mean = mean_of_rays(request.scene, view, full);
      EXPECT_LE(compare_images(mean, after).flip, compare_images(mean, before).flip + request.tolerance);
    }
  }
}

constexpr const char* ambient = "light { type = ambient\n intensity = 0.8 }\n";

std::string ball(const std::string& name, double x, double radius, double z = 4) {
  return "sphere { name = " + name + "\n center = (" + std::to_string(x) + ", 0, " + std::to_string(z) +
         ")\n radius = " + std::to_string(radius) + "\n color = red }\n";
}

// At z = 4 a unit is 16 pixels wide. The speck covers about 4 of the 256 pixels of its tile, the pea about 36.
TEST(ModelNeeds, ASpeckGoesAndAPeaStays) {
  const ModelRequest request =
      request_for(std::string(ambient) + ball("speck", -1.2, 0.07) + ball("pea", 0, 0.21) + ball("fist", 1.2, 0.5));
  const ModelNeeds needs = needs_of(request);
  EXPECT_EQ(names_of(needs.scene), (std::vector<std::string>{"pea", "fist"}));
  const ModelSaving* saving = saving_of(needs, ModelPart::small_objects);
  ASSERT_NE(saving, nullptr);
  EXPECT_EQ(saving->goes, "one small object");
  ASSERT_EQ(saving->things.size(), 1u);
  EXPECT_NEAR(saving->things[0].picture.value_or(0) * 64 * 64, 3.94, 2.1) << "the area of a disc of 1.12 pixels";
  StudyControl control;
  Scene over_reduced = needs.scene;
  over_reduced.geometry.edit([](Geometry& geometry) { geometry.objects.erase(geometry.objects.begin()); });
  EXPECT_GT(check_reduction(request, over_reduced, request.base, control).increase, request.tolerance);
}

/// Without reflected and shadow rays, so that nothing but the maps and volumes of fragments shows what they show.
ModelRequest by_fragments(const std::string& text, const std::string& settings) {
  ModelRequest request = request_for(text);
  request.base = with_renderer(request.base, PictureWay::fragments);
  parse_assignment(settings, request.base);
  return request;
}

TEST(ModelNeeds, WhatOnlyAMapOrAVolumeShowsStays) {
  const std::string mirror = std::string(ambient) +
                             "sphere { name = mirror\n center = (0, 0, 4)\n radius = 1.5\n color = (30, 30, 30)\n "
                             "reflective = 0.9 }\n" +
                             ball("shown", 0, 2, -4) + ball("hidden", 0, 0.5, -40);
  ModelRequest maps = by_fragments(mirror, "environment=cube-map");
  maps.base.reflection_depth = 0;
  const ModelNeeds mapped = needs_of(maps);
  EXPECT_EQ(names_of(mapped.scene), (std::vector<std::string>{"mirror", "shown"}));
  const std::string shadow =
      "light { type = ambient\n intensity = 0.2 }\n"
      "light { type = directional\n intensity = 0.8\n direction = (0, 1, -1) }\n"
      "rectangle { name = floor\n corner = (-9, -1, 0)\n side_a = (0, 0, 20)\n side_b = (18, 0, 0)\n color = white }\n"
      "sphere { name = thrower\n center = (0, 4, -1)\n radius = 1\n color = red }\n"
      "sphere { name = elsewhere\n center = (0, 4, -40)\n radius = 1\n color = red }\n";
  for (const char* method : {"shadows=map", "shadows=stencil-depth-fail"}) {
    SCOPED_TRACE(method);
    const ModelRequest request = by_fragments(shadow, method);
    EXPECT_EQ(names_of(needs_of(request).scene), (std::vector<std::string>{"floor", "thrower"}));
    StudyControl control;
    Scene over_reduced = request.scene;
    over_reduced.geometry.edit([](Geometry& geometry) { geometry.objects.erase(geometry.objects.begin() + 1); });
    EXPECT_GT(check_reduction(request, over_reduced, request.base, control).increase, request.tolerance);
  }
}

TEST(ModelNeeds, DoubleGoesWhereFloatShowsTheSameSurfaces) {
  ModelRequest plain = request_for(std::string(two_lights) + ball("ball", 0, 1));
  plain.base.precision = Precision::float64;
  const ModelSaving* saving = saving_of(needs_of(plain), ModelPart::precision);
  EXPECT_NE(saving, nullptr);
  // Far from the origin, float knows the places of this ball's triangles no better than to half a unit.
  ModelRequest far = request_for(load_scene("lab/far-origin"), 64, 64);
  far.base.precision = Precision::float64;
  EXPECT_EQ(saving_of(needs_of(far), ModelPart::precision), nullptr);
  far.base.precision = Precision::float32;
  const std::vector<ModelRemark> remarks = needs_of(far).remarks;
  EXPECT_TRUE(std::any_of(remarks.begin(), remarks.end(), [](const ModelRemark& remark) {
    return remark.starts_with("Numbers and depths are hardly");
  }));
}

TEST(ModelNeeds, TheSavedSceneIsReadBackAndHolds) {
  const test::ScratchFolder scratch;
  const std::string file = scratch.file("less.scene"), sheet = scratch.file("less.png");
  const auto result =
      test::run_cli({"needs", "cgfs/crates", "--model", "--size", "64x64", "--save", file, "--sheet", sheet, "--json"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_TRUE(json.at("checked").at("holds").get<bool>());
  EXPECT_LE(json.at("bytes"), json.at("default_bytes"));
  const Image<Rgb8> sides = load_levels(sheet);
  EXPECT_GE(sides.width(), 3 * 64);
  EXPECT_GE(sides.height(), 2 * 64) << "by rays and by fragments";
  const Scene saved = load_scene(file);
  EXPECT_EQ(saved.canvas_width, 64);
  EXPECT_EQ(test::run_cli({"needs", "cgfs/crates", "--views", "orbit:3"}).status, 2) << "without --model";
  EXPECT_EQ(test::run_cli({"needs", "cgfs/crates", "--model", "--views", "orbit:0"}).status, 2);
}

TEST(ModelNeeds, AnObjFileHoldsTheSameMesh) {
  const test::ScratchFolder scratch;
  const Scene scene = load_scene("cgfs/crates");
  const Mesh& mesh = *scene.geometry->meshes.front();
  const Mesh read = load_obj(scratch.write("mesh.obj", obj_text(mesh))).mesh;
  EXPECT_EQ(read.positions, mesh.positions);
  EXPECT_EQ(read.uvs, mesh.uvs);
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    EXPECT_EQ(read.triangles[i].position, mesh.triangles[i].position);
    EXPECT_EQ(read.triangles[i].uv, mesh.triangles[i].uv);
  }
}

}  // namespace
}  // namespace ps::model_needs_test
