// Normal mapping against a closed form, and rays against fragments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "frame/display_frame.h"
#include "image/height_map.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/same_bits.h"
#include "support/settings_with.h"
#include "support/simd_targets.h"
#include "textbook/listing_events.h"

namespace ps::normal_map_test {
namespace {

Frame rendered(const Scene& scene, const Settings& settings, int size = 80) {
  return render(scene, View{scene.camera, size, size}, settings, request_for(Channel::normal | Channel::ids));
}

/// A quad that fills the picture, turned out of every axis, with `material` and the texture coordinates of its corners.
/// Front to the eye; u along `right`, v down.
Scene quad(const std::string& normals, const Vec3f& map) {
  Scene scene = parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                            "texture { name = map  generator = checker  size = 1 }\n"
                            "material { name = clay  color = (200, 150, 100)  specular = 20" +
                                std::string(map == Vec3f(0) ? "" : "  normal_map = map") +
                                " }\n"
                                "model { name = quad  materials = [clay]\n"
                                "  vertices { 0 = (-3, -3, 4)  1 = (-3, 3, 5)  2 = (3, 3, 6)  3 = (3, -3, 5) }\n"
                                "  triangles {\n"
                                "    0 = { vertices = [0, 1, 2]  uvs = [(0, 1), (0, 0), (1, 0)] " +
                                normals +
                                " }\n"
                                "    1 = { vertices = [0, 2, 3]  uvs = [(0, 1), (1, 0), (1, 1)] " +
                                normals +
                                " }\n"
                                "  }\n}\n"
                                "instance { model = quad }\n"
                                "light { type = ambient  intensity = 0.2 }\n"
                                "light { type = point  intensity = 0.6  position = (1, 2, 1) }\n"
                                "light { type = directional  intensity = 0.2  direction = (-1, 1, -2) }\n",
                            "quad.scene", ".");
  if (map != Vec3f(0)) {
    std::vector<Texture> textures = *scene.textures;
    textures[0].texels = std::make_shared<const Image<Vec3f>>(Image<Vec3f>(1, 1, map));
    scene.textures = Part<std::vector<Texture>>(std::move(textures));
  }
  return scene;
}

// The quad spans u = (1, 0, 1/6) and, upwards, (0, 1, 1/6): a map of one texel tilts its normal by a known rotation, so
// the picture must be that of the same quad with that vertex normal and no map.
TEST(NormalMap, AConstantMapIsAVertexNormal) {
  const Vec3d along = Vec3d{6, 0, 1} / std::sqrt(37.0), up_edge{0, 6, 1};
  // (b - a) x (c - a) of the first triangle: its front.
  const Vec3d raw = cross(Vec3d{0, 6, 1}, Vec3d{6, 6, 2});
  const Vec3d n = raw / std::sqrt(dot(raw, raw));
  const Vec3d flat_bitangent = cross(n, along);
  const Vec3d bitangent = dot(flat_bitangent, up_edge) < 0 ? -flat_bitangent : flat_bitangent;
  for (const Vec3d& tilt : {Vec3d{0.48, -0.36, 0.8}, Vec3d{-0.6, 0, 0.8}, Vec3d{0, 0.6, 0.8}, Vec3d{0, 0, 1}}) {
    const Vec3d normal = along * tilt.x + bitangent * tilt.y + n * tilt.z;
    char text[256];
    std::snprintf(text, sizeof text, "normals = [(%.17g, %.17g, %.17g), (%.17g, %.17g, %.17g), (%.17g, %.17g, %.17g)]",
                  normal.x, normal.y, normal.z, normal.x, normal.y, normal.z, normal.x, normal.y, normal.z);
    const Scene mapped = quad("", Vec3f(tilt * 0.5 + Vec3d(0.5))), tilted = quad(text, Vec3f(0));
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
      Settings settings{.renderer = renderer};
      settings.precision = Precision::float64;
      settings.shadows = Shadows::none;
      const Frame a = rendered(mapped, settings), b = rendered(tilted, settings);
      settings.normal_mapping = false;
      const Frame flat = rendered(mapped, settings);
      double worst = 0, apart = 0;
      for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
          ASSERT_GE(a.ids.at(x, y).object, 0);
          const Vec3d d = a.colour_double.at(x, y) - b.colour_double.at(x, y);
          worst = std::max(worst, std::sqrt(dot(d, d)));
          const Vec3d off = a.colour_double.at(x, y) - flat.colour_double.at(x, y);
          apart = std::max(apart, std::sqrt(dot(off, off)));
        }
      EXPECT_LT(worst, 1e-6) << static_cast<int>(renderer);  // texels are floats
      if (tilt.z < 1) {
        EXPECT_GT(apart, 0.02) << "without the map the picture is the same";
      }
    }
  }
}

TEST(NormalMap, RaysAndFragmentsAgree) {
  const Scene scene = load_scene("cgfs/brick-wall");
  Settings settings;
  settings.shadows = Shadows::none;
  settings.texture_filter = TextureFilter::bilinear;
  const Frame rays = rendered(scene, settings, 300);
  settings.renderer = Renderer::rasterizer;
  const Frame fragments = rendered(scene, settings, 300);
  int compared = 0, far = 0, on_ball = 0, far_on_ball = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 300; ++x) {
      const int object = rays.ids.at(x, y).object;
      if (object != fragments.ids.at(x, y).object) continue;
      const Vec3f d = rays.colour.at(x, y) - fragments.colour.at(x, y);
      if (object == 0) {  // the wall: the same triangles
        ++compared;
        far += dot(d, d) > 1e-6f ? 1 : 0;
      } else {  // the ball: round for rays, tangents from its triangles for fragments
        ++on_ball;
        far_on_ball += dot(d, d) > 1e-3f ? 1 : 0;
      }
    }
  EXPECT_GT(compared, 50000);
  EXPECT_LT(far, compared / 500);
  EXPECT_GT(on_ball, 5000);
  EXPECT_LT(far_on_ball, on_ball / 20);
}

/// The lesson's listing has its own tangents, axes, weights and texels. Its wall is half mirrored, so that a bitangent
/// without its sign would be seen; the room of cgfs/relief lies along two other axes and reaches far back.
TEST(NormalMap, ColoursAreThoseOfTheListing) {
  for (const char* name : {"chapters/cgfs_15_relief/mirrored.scene", "cgfs/relief"}) {
    const Scene scene = load_scene(name);
    const View view{scene.camera, 300, 200};
    Settings listed = settings_with(settings_for(scene), {"renderer=textbook", "listing=cgfs-15-relief"});
    const Settings drawn = settings_as_listed(listing_of(listed, scene_traits(scene)), scene, listed);
    EXPECT_TRUE(drawn.normal_mapping);
    Settings flat = drawn, bug = listed;
    flat.normal_mapping = false;
    parse_assignment("listing-bug=hollow-bricks", bug);
    const auto levels = [&](const Settings& settings) {
      return display_frame(render(scene, view, settings), settings);
    };
    const Image<Rgb8> a = levels(listed), b = levels(drawn), without = levels(flat), hollow = levels(bug);
    int most = 0, bent = 0, wrong_left = 0, wrong_right = 0, far = 0;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const auto apart = [&](const Image<Rgb8>& one, const Image<Rgb8>& other) {
          const Rgb8 p = one.at(x, y), q = other.at(x, y);
          return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
        };
        most = std::max(most, apart(a, b));
        far += apart(a, b) > 1 ? 1 : 0;
        bent += apart(b, without) > 10 ? 1 : 0;
        (x < view.width / 2 ? wrong_left : wrong_right) += apart(a, hollow) > 10 ? 1 : 0;
      }
    EXPECT_LE(most, 1) << name << ", " << far << " pixels";
    EXPECT_GT(bent, 5000) << name;
    if (std::string(name) == "cgfs/relief") continue;
    EXPECT_EQ(wrong_left, 0);
    EXPECT_GT(wrong_right, 2000);
  }
}

Frame brick_wall(Settings settings, Simd simd) {
  const Scene scene = load_scene("cgfs/brick-wall");
  settings.simd = simd;
  return render(scene, View{scene.camera, 160, 120}, settings);
}

TEST(NormalMap, RaysAgreeOnFastAndClearPath) {
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target: both sides are the clear path";
  const Frame clear = brick_wall({}, Simd::off), fast = brick_wall({}, Simd::automatic);
  EXPECT_TRUE(test::same_bits(clear.colour, fast.colour));
  EXPECT_NE(clear.counters[Counter::node_visits], fast.counters[Counter::node_visits]) << "both are the clear path";
}

/// For fragments there is nothing to compare: with a normal map the rasterizer takes the clear path, whatever the SIMD
/// target. The map alone is the reason.
TEST(NormalMap, FragmentsTakeTheClearPath) {
  Settings settings{.renderer = Renderer::rasterizer};
  EXPECT_FALSE(test::took_fast_frame(brick_wall(settings, Simd::automatic)));
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target";
  settings.normal_mapping = false;
  EXPECT_TRUE(test::took_fast_frame(brick_wall(settings, Simd::automatic)));
}

// On a sphere the map's middle row looks along the equator: (0.5, 0.5, 1) is no tilt, and a tilt along u turns the
// normal eastwards by its angle.
TEST(NormalMap, OnASphereRedLeansEast) {
  const double angle = 0.3;
  const Vec3d tilt{std::sin(angle), 0, std::cos(angle)};
  Scene scene = parse_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                            "texture { name = map  generator = checker  size = 1 }\n"
                            "sphere { center = (0, 0, 4)  radius = 1.5  color = white  normal_map = map }\n"
                            "light { type = directional  intensity = 1  direction = (0, 0, -1) }\n",
                            "ball.scene", ".");
  std::vector<Texture> textures = *scene.textures;
  textures[0].texels = std::make_shared<const Image<Vec3f>>(Image<Vec3f>(1, 1, Vec3f(tilt * 0.5 + Vec3d(0.5))));
  scene.textures = Part<std::vector<Texture>>(std::move(textures));
  Settings settings;
  settings.precision = Precision::float64;
  const Frame frame = rendered(scene, settings, 81);
  for (int y = 20; y < 61; y += 10)
    for (int x = 20; x < 61; x += 10) {
      settings.normal_mapping = false;
      const Vec3d own(rendered(scene, settings, 81).normal.at(x, y));
      const Vec3d east = Vec3d{-own.z, 0, own.x} / std::sqrt(own.x * own.x + own.z * own.z);
      const Vec3d expected = own * std::cos(angle) + east * std::sin(angle);
      const Vec3d got(frame.normal.at(x, y));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-6);
    }
}

TEST(HeightMap, APlaneOfHeightsTiltsByItsSlope) {
  Image<Vec3f> ramp(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ramp.at(x, y) = Vec3f(static_cast<float>(x) / 16 + static_cast<float>(y) / 32);
  EXPECT_TRUE(is_height_map(ramp));
  const Image<Vec3f> normals = normals_from_heights(ramp, 8);
  const Vec3d expected = Vec3d{-0.5, 0.25, 1} / std::sqrt(0.25 + 0.0625 + 1);
  const Vec3f got = normals.at(7, 7) * 2.0f - Vec3f(1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-5);
  EXPECT_FALSE(is_height_map(normals));
}

}  // namespace
}  // namespace ps::normal_map_test
