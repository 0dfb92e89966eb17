// Parallax mapping against planes and grooves that are really there.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::parallax_test {
namespace {

constexpr int columns = 120, rows = 80;

Frame rendered(const Scene& scene, const Settings& settings) {
  return render(scene, View{scene.camera, columns, rows}, settings, request_for(Channel::ids | Channel::uv));
}

Settings settings_with(Renderer renderer, Parallax parallax, int steps = 64) {
  Settings settings{.renderer = renderer};
  settings.precision = Precision::float64;
  settings.near = 0.01;
  settings.backface_culling = false;
  settings.texture_filter = TextureFilter::bilinear;
  settings.parallax = parallax;
  settings.parallax_steps = steps;
  settings.tessellation = 0.05;
  return settings;
}

/// A camera over a floor at y = 0, at `degrees` to it, that looks at (0, 0, 3).
std::string camera(double degrees) {
  const double a = degrees * std::numbers::pi / 180, s = std::sin(a), c = std::cos(a);
  return fmt::format("viewport_size = 1.5 x 1\nprojection_plane_d = 1\nbackground = black\n"
                     "camera {{ position = (0, {}, {})  right = (1, 0, 0)  up = (0, {}, {})  forward = (0, {}, {}) }}\n"
                     "light {{ type = ambient  intensity = 1 }}\n",
                     3 * s, 3 - 3 * c, c, s, -s, c);
}

Scene with_heights(Scene scene, Image<Vec3f> heights) {
  std::vector<Texture> textures = *scene.textures;
  textures.at(0).texels = std::make_shared<const Image<Vec3f>>(std::move(heights));
  scene.textures = Part<std::vector<Texture>>(std::move(textures));
  return scene;
}

/// A floor at height `y` that fills the view; u = x / 2 + z / 5 and v = z / 3, so the picture lies skewed on it.
Scene floor_at(double degrees, double y, const std::string& material) {
  const auto corner = [&](double x, double z) { return fmt::format("({}, {})", x / 2 + z / 5, z / 3); };
  const double w = 40, near = -20, far = 60;
  return parse_scene(
      camera(degrees) +
          "texture { name = map  generator = checker  size = 1 }\nmaterial { name = clay  color = white " + material +
          fmt::format(
              " }}\nmodel {{ name = floor  materials = [clay]\n vertices {{ 0 = ({0}, {1}, {2})  1 = ({0}, {1}, "
              "{3})  2 = ({4}, {1}, {3})  3 = ({4}, {1}, {2}) }}\n",
              -w, y, near, far, w) +
          "triangles { 0 = { vertices = [0, 1, 2]  uvs = [" + corner(-w, near) + ", " + corner(-w, far) + ", " +
          corner(w, far) + "] }\n 1 = { vertices = [0, 2, 3]  uvs = [" + corner(-w, near) + ", " + corner(w, far) +
          ", " + corner(w, near) + "] } }\n}\ninstance { model = floor }\n",
      "floor.scene", ".");
}

/// Largest distance between the texture coordinates of two pictures where both show something.
double furthest(const Frame& a, const Frame& b, int& compared) {
  double worst = 0;
  compared = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      if (a.ids.at(x, y).object < 0 || b.ids.at(x, y).object < 0) continue;
      ++compared;
      const Vec2f d = a.uv.at(x, y) - b.uv.at(x, y);
      worst = std::max(worst, static_cast<double>(std::hypot(d.x, d.y)));
    }
  return worst;
}

// A relief of one height is a plane that lies lower: by (1 - h) * relief_depth widths of the picture, which is 2 wide.
TEST(Parallax, AConstantHeightIsALowerPlane) {
  constexpr double depth = 0.2;
  constexpr float height = 0.25F;
  const double below = (1 - static_cast<double>(height)) * depth * 2;
  const Scene relief =
      with_heights(floor_at(50, 0, "height_map = map  relief_depth = 0.2"), Image<Vec3f>(1, 1, Vec3f(height)));
  const Scene lower = floor_at(50, -below, "height_map = map");
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    const Frame truth = rendered(lower, settings_with(renderer, Parallax::off));
    const auto error = [&](Parallax parallax, int steps) {
      int compared = 0;
      const double worst = furthest(rendered(relief, settings_with(renderer, parallax, steps)), truth, compared);
      EXPECT_EQ(compared, columns * rows);
      return worst;
    };
    EXPECT_LT(error(Parallax::offset, 1), 2e-5);  // channels are floats
    EXPECT_LT(error(Parallax::occlusion, 7), 2e-5);
    EXPECT_LT(error(Parallax::steep, 256), 0.004);
    EXPECT_GT(error(Parallax::steep, 7), 0.004);
    EXPECT_GT(error(Parallax::limited, 1), 0.02);
    EXPECT_GT(error(Parallax::off, 1), 0.1);
  }
}

constexpr int texels = 32;
/// Grooves across u: trapezoids, given at texel centres, between which bilinear lookups run straight.
double groove(int texel) {
  const int at = (texel % texels + texels) % texels % 16;
  return at < 6 ? 1 : at == 6 || at == 15 ? 0.5 : 0;
}
constexpr double groove_depth = 0.03;  // in widths of the picture, 4

/// The grooves as a picture on a floor, or as a surface whose corners lie at texel centres. u = -z / 4: the camera
/// looks across them.
Scene grooves(double degrees, bool really) {
  std::string vertices, triangles;
  int count = 0;
  const int first = -6 * texels, last = 3 * texels;
  for (int i = first; i <= last; i += really ? 1 : last - first) {
    const double u = (i + 0.5) / texels, z = -4 * u;
    const double y = really ? -(1 - groove(i)) * groove_depth * 4 : 0;
    vertices += fmt::format("{} = (-60, {}, {})  {} = (60, {}, {})\n", 2 * count, y, z, 2 * count + 1, y, z);
    if (count > 0) {
      const double before = really ? u - 1.0 / texels : (first + 0.5) / texels;
      const int c = 2 * count;
      triangles += fmt::format("{} = {{ vertices = [{}, {}, {}]  uvs = [({}, 0), ({}, 0), ({}, 30)] }}\n"
                               "{} = {{ vertices = [{}, {}, {}]  uvs = [({}, 0), ({}, 30), ({}, 30)] }}\n",
                               c, c, c - 2, c + 1, u, before, u, c + 1, c - 2, c - 1, c + 1, before, before, u);
    }
    ++count;
  }
  Scene scene = parse_scene(camera(degrees) +
                                fmt::format("texture {{ name = map  generator = checker  size = 1 }}\n"
                                            "material {{ name = clay  color = white  height_map = map  relief_depth = "
                                            "{} }}\nmodel {{ name = floor  materials = [clay]\nvertices {{ {} }}\n"
                                            "triangles {{ {} }}\n}}\ninstance {{ model = floor }}\n",
                                            groove_depth, vertices, triangles),
                            "grooves.scene", ".");
  Image<Vec3f> heights(texels, 1);
  for (int x = 0; x < texels; ++x) heights.at(x, 0) = Vec3f(static_cast<float>(groove(x)));
  return with_heights(std::move(scene), std::move(heights));
}

/// Share (%) of the pixels whose u is off by more than half a texel, near the middle of the picture.
double wrong_share(double degrees, Renderer renderer, Parallax parallax, int steps) {
  const Frame truth = rendered(grooves(degrees, true), settings_with(Renderer::ray_tracer, Parallax::off));
  const Frame frame = rendered(grooves(degrees, false), settings_with(renderer, parallax, steps));
  int compared = 0, wrong = 0;
  for (int y = rows / 4; y < rows * 3 / 4; ++y)
    for (int x = 0; x < columns; ++x) {
      if (truth.ids.at(x, y).object < 0 || frame.ids.at(x, y).object < 0) continue;
      ++compared;
      if (std::abs(truth.uv.at(x, y).x - frame.uv.at(x, y).x) > 0.5F / texels) ++wrong;
    }
  EXPECT_GT(compared, columns * rows / 3);
  return 100.0 * wrong / compared;
}

TEST(Parallax, OcclusionShowsTheGroovesThatAreThere) {
  for (const double degrees : {70.0, 40.0, 20.0}) {
    const double rays = wrong_share(degrees, Renderer::ray_tracer, Parallax::occlusion, 256);
    const double fragments = wrong_share(degrees, Renderer::rasterizer, Parallax::occlusion, 256);
    EXPECT_LT(rays, 2) << degrees;
    EXPECT_LT(fragments, 2) << degrees;
    if (degrees < 60) {
      EXPECT_GT(wrong_share(degrees, Renderer::rasterizer, Parallax::off, 1), 20) << degrees;
    }
  }
}

// One reading of the height cannot know what the line of sight meets on its way: the flatter the view, the worse. Nor
// can few steps.
TEST(Parallax, OffsetsFailAtFlatAngles) {
  const auto offset = [](double degrees) { return wrong_share(degrees, Renderer::rasterizer, Parallax::offset, 1); };
  const double steep_view = offset(70), middle = offset(40), flat = offset(15);
  std::printf("offset off by half a texel: %.1f %% at 70, %.1f %% at 40, %.1f %% at 15 degrees\n", steep_view, middle,
              flat);
  EXPECT_LT(steep_view, middle);
  EXPECT_LT(middle, flat);
  EXPECT_GT(flat, 25);
  EXPECT_GT(wrong_share(20, Renderer::rasterizer, Parallax::steep, 4), 5);
  EXPECT_LT(wrong_share(20, Renderer::rasterizer, Parallax::steep, 256), 2);
}

// The same scene, both renderers: the wall and floor of the built-in scene, as far as filters agree.
TEST(Parallax, RaysAndFragmentsAgree) {
  Scene scene = load_scene("cgfs/relief");
  Settings settings;
  settings.parallax = Parallax::occlusion;
  settings.shadows = Shadows::none;
  settings.near = 0.1;
  settings.texture_filter = TextureFilter::bilinear;
  const Frame rays = rendered(scene, settings);
  settings.renderer = Renderer::rasterizer;
  const Frame fragments = rendered(scene, settings);
  int compared = 0, far = 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      if (!(rays.ids.at(x, y) == fragments.ids.at(x, y)) || rays.ids.at(x, y).object < 0) continue;
      ++compared;
      const Vec3f d = rays.colour.at(x, y) - fragments.colour.at(x, y);
      far += dot(d, d) > 1e-4F ? 1 : 0;
    }
  EXPECT_GT(compared, 4000);
  EXPECT_LT(far, compared / 50);
}

// Along the equator of a ball and around a cylinder, one width of the picture is the circumference: a constant height
// is a smaller ball or cylinder. Seen from straight before, both agree in the first order around the middle.
TEST(Parallax, RoundThingsUseTheirOwnLengths) {
  for (const char* shape :
       {"sphere { center = (0, 0, 4)  radius = 1", "cylinder { from = (0, -1, 4)  to = (0, 1, 4)  radius = 1"}) {
    const auto scene = [&](const char* material) {
      return with_heights(
          parse_scene(std::string("viewport_size = 1.5 x 1\nprojection_plane_d = 1\nbackground = black\n"
                                  "texture { name = map  generator = checker  size = 1 }\n") +
                          shape + "  color = white  " + material + " }\nlight { type = ambient  intensity = 1 }\n",
                      "round.scene", "."),
          Image<Vec3f>(1, 1, Vec3f(0)));
    };
    const Frame flat = rendered(scene("texture = map"), settings_with(Renderer::ray_tracer, Parallax::off));
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
      const Frame deep = rendered(scene("texture = map  height_map = map  relief_depth = 0.01"),
                                  settings_with(renderer, Parallax::offset));
      // At an angle phi off the middle the shift along the surface is 0.01 * 2 pi * tan(angle between n and v).
      for (const int x : {columns / 2 - 12, columns / 2 + 12}) {
        const int y = rows / 2;
        const Vec3d ray{(x + 0.5 - columns / 2.0) / rows, 0, 1};
        const double square = dot(ray, ray), t = (4 - std::sqrt(16 - 15 * square)) / square;
        const Vec3d point = ray * t, normal = point - Vec3d{0, 0, 4};
        const double cosine = dot(normal, -point) / std::sqrt(dot(point, point));
        const double expected = 0.01 * std::sqrt(1 - cosine * cosine) / cosine;
        const double moved = static_cast<double>(deep.uv.at(x, y).x - flat.uv.at(x, y).x);
        EXPECT_NEAR(std::abs(moved), expected, expected * 0.03 + 1e-5) << shape;
        const bool u_grows = flat.uv.at(x + 1, y).x > flat.uv.at(x, y).x;
        EXPECT_EQ(moved > 0, u_grows == (ray.x > 0)) << "further in means further from the middle";
      }
    }
  }
}

}  // namespace
}  // namespace ps::parallax_test
