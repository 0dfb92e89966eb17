// Scenes far from the world's origin, as maps put them: pictures of all renderers are those of the same scene at the
// origin, and the numbers of stories are those of the world.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "inspect/story_json.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "render/provenance.h"
#include "scene/float_limits.h"
#include "scene/scene_file.h"
#include "support/golden.h"
#include "support/render_once.h"
#include "support/shown_levels.h"

namespace ps::far_scenes_test {
namespace {

constexpr int width = 96, height = 72;
const std::array<Vec3d, 4> far_places{Vec3d{5e5, 120, 5.5e6}, Vec3d{-5.5e6, 5e5, 3e5}, Vec3d{4e5, -3e6, 200},
                                      Vec3d{3e7, -3e7, 3e7}};

/// A folder with a picture that changes slowly.
std::filesystem::path picture_folder() {
  auto folder = fresh_output_folder("far-scenes");
  std::string picture = "P3 64 64 255\n";
  const auto wave = [](double at) { return static_cast<int>(127.5 + 60 * std::sin(at)); };
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      picture += fmt::format("{} {} {}\n", wave(0.2 * x), wave(0.15 * y), wave(0.1 * (x + y)));
  write_file_atomically(folder / "t.ppm", picture);
  return folder;
}

/// Textures, a relief, a mirror that asks for an environment map and one with a picture of its own around `o`. The
/// vertices of the wall are far away themselves, those of the pyramid are brought there.
Scene scene_at(const Vec3d& o, const std::filesystem::path& folder, double size = 1) {
  const auto length = [&](double units) { return fmt::format("{:.17g}", size * units); };
  const auto at = [&](double x, double y, double z) {
    return fmt::format("({:.17g},{:.17g},{:.17g})", o.x + size * x, o.y + size * y, o.z + size * z);
  };
  std::string text = "background = (200,210,255) projection_plane_d = " + length(1) + " viewport_size = " + length(1) +
                     " x " + length(0.75) +
                     " texture { name = t file = t.ppm } "
                     "material { name = paper color = white texture = t } "
                     "material { name = bumps color = (220,200,180) specular = 20 normal_map = t } "
                     "material { name = relief color = white texture = t height_map = t relief_depth = 0.04 } "
                     "material { name = chrome color = (80,80,80) reflective = 0.6 } "
                     "material { name = sky color = (80,80,80) reflective = 0.6 reflection_map = t } ";
  text += "camera { position = " + at(0.5, 1, -4) + " } ";
  text += "sphere { center = " + at(-1, 0.1, 0.2) + " radius = " + length(0.6) + " material = chrome } ";
  text += "sphere { center = " + at(-0.1, -0.3, -0.8) + " radius = " + length(0.3) + " material = sky } ";
  text += "sphere { center = " + at(0.3, 0.6, 0.8) + " radius = " + length(0.4) + " material = bumps } ";
  text += "model { name = wall material = relief vertices = [" + at(0.2, -0.7, 1) + ", " + at(0.2, 1.2, 1) + ", " +
          at(2.2, 1.2, 0.3) + ", " + at(2.2, -0.7, 0.3) +
          "] uvs = [(0,0),(0,1),(1,1),(1,0)] triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] } "
          "1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] } } } instance { model = wall } ";
  text += "model { name = pyramid material = paper vertices = [(0,0,0),(1,0,0),(0.5,1,0.5),(0.5,0,1)] uvs = "
          "[(0,0),(1,0),(0.5,1),(0.5,0.5)] triangles { 0 = { vertices = [0, 2, 1] uvs = [0, 2, 1] } 1 = { vertices = "
          "[1, 2, 3] uvs = [1, 2, 3] } 2 = { vertices = [3, 2, 0] uvs = [3, 2, 0] } } } instance { model = pyramid "
          "transform = { scale = " +
          length(0.7) + " translation = " + at(0.5, -0.6, -1.2) + " } } ";
  text += "rectangle { corner = " + at(-6, -0.7, -6) + " side_a = (0,0," + length(12) + ") side_b = (" + length(12) +
          ",0,0) material = paper } ";
  text += "light { type = ambient intensity = 0.2 } light { type = point intensity = 0.7 position = " + at(2, 4, -3) +
          fmt::format(" attenuation = (0.5,{:.17g},{:.17g}) }} ", 0.1 / size, 0.01 / size / size);
  return parse_scene(text, "far.scene", folder.string());
}

std::vector<Renderer> renderers() {
  std::vector<Renderer> all{Renderer::ray_tracer, Renderer::rasterizer};
  std::string reason;
  if (const auto hardware = test::hardware_here(reason)) all.push_back(*hardware);
  return all;
}

Settings settings_of(Renderer renderer, const std::vector<std::string>& assignments) {
  Settings settings{.renderer = renderer};
  settings.environment = Environment::cube_map;
  settings.environment_size = 64;
  settings.shadow_map_size = 128;
  settings.parallax = Parallax::occlusion;
  for (const std::string& one : assignments) parse_assignment(one, settings);
  return settings;
}

Image<Rgb8> levels_of(const Scene& scene, const Settings& settings) {
  return test::levels_of(scene, settings, width, height);
}

TEST(FarScenes, LookAsTheyDoAtTheOrigin) {
  constexpr int edges = 40;  // of 6,912 pixels: numbers in the file have 17 digits, floats 7
  const auto folder = picture_folder();
  const std::vector<std::vector<std::string>> cases{
      {}, {"shadows=map"}, {"shadows=stencil-depth-fail"}, {"shading=gouraud"}, {"texture-filter=nearest"}};
  const Scene home = scene_at({0, 0, 0}, folder);
  for (const Renderer renderer : renderers())
    for (const auto& assignments : cases) {
      if (renderer == Renderer::ray_tracer && !assignments.empty() && assignments[0] != "texture-filter=nearest")
        continue;
      Settings settings = settings_of(renderer, assignments);
      const Image<Rgb8> wanted = levels_of(home, settings);
      for (const Vec3d& place : far_places) {
        const Scene far = scene_at(place, folder);
        EXPECT_LE(test::differing(levels_of(far, settings), wanted), edges)
            << fmt::format("{} {} at {}", static_cast<int>(renderer), fmt::join(assignments, " "), place.x);
        EXPECT_EQ(left_out_words(scene_traits(far), settings), left_out_words(scene_traits(home), settings));
      }
    }
  Settings absolute = settings_of(Renderer::rasterizer, {"camera-relative=off"});
  EXPECT_GT(test::differing(levels_of(scene_at(far_places[0], folder), absolute), levels_of(home, absolute)), 500);
}

TEST(FarScenes, LookTheSameInAnySize) {
  const auto folder = picture_folder();
  const Scene home = scene_at({0, 0, 0}, folder);
  for (const Renderer renderer : renderers())
    for (const std::vector<std::string>& assignments : std::vector<std::vector<std::string>>{
             {"shadows=map"}, {"shadows=stencil-depth-fail"}, {"precision=double", "shadows=map"}}) {
      const Settings settings = settings_of(renderer, assignments);
      const Image<Rgb8> wanted = levels_of(home, settings);
      for (const double size : {0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e3, 1e6})
        EXPECT_LE(test::differing(levels_of(scene_at({0, 0, 0}, folder, size), settings), wanted), 8)
            << fmt::format("{} {} size {}", static_cast<int>(renderer), fmt::join(assignments, " "), size);
    }
}

/// One vector, or some one after the other.
bool is_vectors(const nlohmann::json& value) {
  return value.is_array() && !value.empty() && value.size() % 3 == 0 &&
         std::all_of(value.begin(), value.end(), [](const nlohmann::json& one) { return one.is_number(); });
}

/// The numbers of two values of the same shape. A number or a vector of three may be moved by `place`, or not at all:
/// directions and colours stay, and places move. Gives how many vectors moved.
int compare_numbers(const nlohmann::json& far, const nlohmann::json& home, const Vec3d& place,
                    const std::string& path) {
  int moved = 0;
  if (home.is_number()) {
    const double a = far.get<double>(), b = home.get<double>();
    EXPECT_NEAR(a, b, 1e-3 * std::max(1.0, std::abs(b))) << path;
  } else if (is_vectors(home) && is_vectors(far) && far.size() == home.size()) {
    for (std::size_t i = 0; i < home.size(); i += 3) {
      double shift = 0, rest = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t k = i + static_cast<std::size_t>(axis);
        const double by = far[k].get<double>() - home[k].get<double>();
        shift = std::max(shift, std::abs(by));
        rest = std::max(rest, std::abs(by - place[axis]));
      }
      EXPECT_LT(std::min(shift, rest), 2e-2) << path << ": " << far << " " << home;
      moved += rest < shift ? 1 : 0;
    }
  } else if (home.is_array() && far.is_array()) {
    EXPECT_EQ(far.size(), home.size()) << path;
    for (std::size_t i = 0; i < std::min(far.size(), home.size()); ++i)
      moved += compare_numbers(far[i], home[i], place, path + "/" + std::to_string(i));
  } else if (home.is_object() && far.is_object()) {
    for (const auto& [key, value] : home.items()) {
      EXPECT_TRUE(far.contains(key)) << path << "/" << key;
      if (far.contains(key)) moved += compare_numbers(far[key], value, place, path + "/" + key);
    }
  }
  return moved;
}

TEST(FarScenes, StoriesTellTheNumbersOfTheWorld) {
  const auto folder = picture_folder();
  const Vec3d place = far_places[0];
  const Scene far = scene_at(place, folder), home = scene_at({0, 0, 0}, folder);
  for (const Renderer renderer : renderers())
    for (const char* shadows : {"shadows=none", "shadows=map", "shadows=stencil-depth-fail", "shadows=traced"}) {
      const Settings settings = settings_of(renderer, {shadows, "accelerator=none"});
      int moved = 0;
      // A mirror, the relief, bumps, the pyramid and the floor; none of them lies at an edge.
      for (const Vec2i pixel : {Vec2i{24, 38}, {70, 36}, {44, 24}, {56, 42}, {20, 66}}) {
        const auto story_of = [&](const Scene& scene) {
          const View view{scene.camera, width, height};
          const PixelStory story = inspect(scene, view, settings, pixel);
          return nlohmann::json::parse(story_json(story, scene, view, provenance_of(settings)))["events"];
        };
        moved += compare_numbers(story_of(far), story_of(home), place,
                                 fmt::format("{} {} {},{}", static_cast<int>(renderer), shadows, pixel.x, pixel.y));
      }
      EXPECT_TRUE(moved > 9 || renderer != Renderer::ray_tracer) << shadows;
    }
}

// ---- What float cannot hold wherever its origin is
// --------------------------------------------------------------------

/// A ground and two cubes of 1 and 2 units as one mesh. The cubes and the eye are so far from the ground's middle.
Scene town(double away, double ground, const std::string& light, const std::string& folder) {
  std::string obj;
  int vertices = 0;
  const auto vertex = [&](double x, double y, double z) {
    obj += fmt::format("v {:.17g} {:.17g} {:.17g}\n", x, y, z);
    ++vertices;
  };
  for (const auto& [x, z, size] : {std::array{0.0, 7.0, 2.0}, {2.2, 7.5, 1.0}}) {
    const int first = vertices + 1;
    for (int corner = 0; corner < 8; ++corner)
      vertex(away + x + size * ((corner & 1) - 0.5), size * (corner >> 1 & 1), z + size * ((corner >> 2 & 1) - 0.5));
    for (const char* face : {"0 2 3 1", "4 5 7 6", "0 4 6 2", "1 3 7 5", "2 6 7 3"}) {
      obj += "f";
      for (const char* c = face; *c != 0; ++c)
        if (*c != ' ') obj += fmt::format(" {}", first + (*c - '0'));
      obj += "\n";
    }
  }
  const int first = vertices + 1;
  for (const auto& [x, z] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}) vertex(x * ground, 0, z * ground);
  obj += fmt::format("f {} {} {} {}\n", first, first + 1, first + 2, first + 3);
  write_file_atomically(std::filesystem::path(folder) / "town.obj", obj);
  return parse_scene(fmt::format("viewport_size = 1 x 0.75 canvas_size = 96 x 72 background = white camera {{ position "
                                 "= ({0:.17g},2.5,0) }} model {{ name = m file = town.obj color = (200,120,80) }} "
                                 "instance {{ model = m }} light {{ type = ambient intensity = 0.2 }} {1}",
                                 away, light),
                     "town.scene", folder);
}

bool says_double(const Scene& scene, Renderer renderer) {
  return left_out_words(scene_traits(scene), settings_of(renderer, {"shadows=none"})).find("round") !=
         std::string::npos;
}

TEST(FarScenes, WhatFloatCannotHoldIsSaid) {
  const std::string folder = fresh_output_folder("far-scenes-town").string();
  const auto lamp = [](double away) {
    return fmt::format("light {{ type = point intensity = 0.6 position = ({:.17g},5,2) }}", away + 3);
  };
  struct Case {
    double away, ground;
    bool said;
  };
  for (const Case& one : {Case{0, 50, false}, {0, 1e4, false}, {20, 50, false}, {5e6, 1e7, true}, {1e5, 2e5, true}}) {
    const Scene scene = town(one.away, one.ground, lamp(one.away), folder);
    for (const Renderer renderer : renderers()) {
      EXPECT_EQ(says_double(scene, renderer), one.said) << one.away << " " << one.ground << " " << int(renderer);
      if (one.said || renderer == Renderer::ray_tracer) continue;
      // Where no line asks for double, no difference is seen.
      Settings exact = settings_of(Renderer::rasterizer, {"shadows=none", "precision=double"});
      EXPECT_LE(test::differing(levels_of(scene, settings_of(renderer, {"shadows=none"})), levels_of(scene, exact)), 20)
          << one.away << " " << one.ground << " " << int(renderer);
    }
  }
  // A ground so large that the points near the eye are rounded where fragments interpolate them, and not for rays.
  const Scene plain = town(0, 1e7, lamp(0), folder);
  EXPECT_FALSE(says_double(plain, Renderer::ray_tracer));
  EXPECT_TRUE(says_double(plain, Renderer::rasterizer));
  Settings exact = settings_of(Renderer::rasterizer, {"shadows=none", "precision=double"});
  EXPECT_GT(
      test::differing(levels_of(plain, settings_of(Renderer::rasterizer, {"shadows=none"})), levels_of(plain, exact)),
      200);
  EXPECT_EQ(left_out_words(scene_traits(plain), exact), "");
  // Under light that has no place they look the same.
  EXPECT_FALSE(says_double(town(0, 1e7, "light { type = directional intensity = 0.6 direction = (1,2,-1) }", folder),
                           Renderer::rasterizer));
}

TEST(FarScenes, LightsThatTouchASurfaceAreFound) {
  const auto found = [](const std::string& objects, const std::string& light) {
    return float_limits(
               parse_scene(objects + " light { type = point intensity = 0.5 " + light + " }", "lamp.scene", "."))
        .light_at_surface;
  };
  const std::array<std::string, 6> bodies{
      "sphere { center = (0,0,3) radius = 1 }",
      "rectangle { corner = (-1,-1,2) side_a = (2,0,0) side_b = (0,2,0) }",
      "plane { point = (5,7,2) normal = (0,0,-1) }",
      "box { center = (0,0,3) size = (2,2,2) }",
      "cylinder { from = (0,0,2) to = (0,0,4) radius = 1 }",
      "model { name = m color = white vertices = [(-1,-1,2), (1,-1,2), (0,2,2)] triangles { (0,2,1,white) } } "
      "instance { model = m }"};
  for (const std::string& body : bodies) {
    for (const char* near : {"2", "1.9999999999999999", "1.99999999", "2.00000001"})
      EXPECT_TRUE(found(body, fmt::format("position = (0,0,{})", near))) << body << near;
    for (const char* other : {"position = (0,0,1.9)", "position = (0,0,2.2)", "position = (30,0,2.1)"})
      EXPECT_FALSE(found(body, other)) << body << other;
  }
}

}  // namespace
}  // namespace ps::far_scenes_test
