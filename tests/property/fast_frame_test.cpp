// The fast path of whole pictures against the clear path, on triangles of every kind that it treats apart: smaller than
// a pixel, small, large, cut by the planes and by the guard band, flat, behind the camera, one before the other; and on
// the scenes that Pixelscope ships with, under options drawn at random.
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "frame/display_frame.h"
#include "image/display.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/random_scene.h"
#include "support/same_bits.h"
#include "support/simd_targets.h"
#include "support/trials.h"

namespace ps::fast_frame_test {
namespace {

using ps::test::same_bits;

/// Triangles without any order, of sizes from a hundredth of a pixel to the whole picture, with and without normals.
std::shared_ptr<const Mesh> soup(std::mt19937& random, int triangles) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> dice(0, 9);
  auto mesh = std::make_shared<Mesh>();
  const auto direction = [&] { return Vec3d(unit(random), unit(random), unit(random)); };
  for (int i = 0; i < triangles; ++i) {
    const double z = dice(random) == 0 ? 2.0 * unit(random) : 3 + 2 * unit(random);
    const Vec3d centre(unit(random) * z, unit(random) * z, z);
    const double size = std::pow(10.0, -1.7 + 1.7 * unit(random));
    MeshTriangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.position[k] = static_cast<std::uint32_t>(mesh->positions.size());
      mesh->positions.push_back(centre + size * direction());
      if (dice(random) > 0) {
        triangle.normal[k] = static_cast<std::int32_t>(mesh->normals.size());
        mesh->normals.push_back(direction());
      }
      if (dice(random) > 0) {
        triangle.uv[k] = static_cast<std::int32_t>(mesh->uvs.size());
        mesh->uvs.emplace_back(4 * unit(random), 4 * unit(random));
      }
    }
    if (dice(random) == 0) triangle.position[2] = triangle.position[0];
    triangle.material = static_cast<std::uint32_t>(dice(random) % 3);
    mesh->triangles.push_back(triangle);
  }
  // A strip that crosses the picture at one depth, whose neighbours share their edges exactly.
  for (int i = 0; i < 40; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (const double y : {-0.4, 0.5}) mesh->positions.emplace_back(-2 + 0.1 * i, y + 0.01 * i, 2.5);
    if (i == 0) continue;
    MeshTriangle& lower = mesh->triangles.emplace_back();
    lower.position = {first - 2, first - 1, first};
    MeshTriangle& upper = mesh->triangles.emplace_back();
    upper.position = {first, first - 1, first + 1};
    lower.material = upper.material = static_cast<std::uint32_t>(i % 3);
  }
  mesh->materials = {0, 1, 2};
  return mesh;
}

Scene soup_scene(std::mt19937& random) {
  Scene scene;
  scene.materials.edit([](std::vector<Material>& materials) {
    materials.resize(3);
    materials[0].colour = {0.9, 0.3, 0.2};
    materials[0].specular = 20;
    materials[1].texture = 0;
    materials[2].colour = {0.1, 0.6, 0.9};
    materials[2].texture = 1;
  });
  Image<Vec3f> texels(37, 20);
  std::uniform_real_distribution<float> level(0, 1);
  for (Vec3f& texel : texels.pixels()) texel = {level(random), level(random), level(random)};
  // The same as a picture file holds it, which the fast path keeps in another form.
  Image<Rgb8> levels = display_image(texels);
  levels.pixels()[0] = {0, 0, 0};
  levels.pixels()[1] = {255, 255, 255};
  Texture noise, file;
  noise.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
  file.texels = std::make_shared<const Image<Vec3f>>(to_unit(levels));
  scene.textures.edit([&](std::vector<Texture>& textures) { textures = {noise, file}; });
  scene.lights.edit([](std::vector<Light>& lights) {
    lights.resize(3);
    lights[0].intensity = 0.2;
    lights[1].kind = LightKind::point;
    lights[1].position = {1, 2, 0};
    lights[2].kind = LightKind::directional;
    lights[2].direction = {-1, 1, -1};
  });
  scene.geometry.edit([&](Geometry& geometry) {
    geometry.meshes = {soup(random, 900), soup(random, 3000)};
    geometry.objects.push_back({"few", Instance{}});
    Instance turned;
    turned.mesh = 1;
    geometry.objects.push_back({"many", turned});
  });
  return scene;
}

Frame draw(const Scene& scene, const Settings& settings, int width, int height) {
  static Prepared prepared;  // what scenes are made into does not depend on how it is drawn
  Progress progress;
  return render(scene, {scene.camera, width, height}, settings, {}, prepared, progress);
}

void expect_equal(const Frame& clear, const Frame& fast, const std::string& what) {
  EXPECT_TRUE(same_bits(clear.colour, fast.colour)) << what;
  for (std::size_t i = 0; i < counter_count; ++i)
    EXPECT_EQ(clear.counters.values[i], fast.counters.values[i])
        << counter_key(static_cast<Counter>(i)) << ", " << what;
}

TEST(FastFrame, IsTheClearPathToTheLastBit) {
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target";
  constexpr unsigned seed = 20240;
  std::mt19937 random(seed);
  const Scene scene = soup_scene(random);
  for (const std::vector<std::string>& variant : std::vector<std::vector<std::string>>{
           {},
           {"backface-culling=off"},
           {"fill-rule=inclusive", "subpixel-bits=4", "texture-filter=nearest"},
           {"fill-rule=exclusive", "subpixel-bits=0", "texture-filter=bilinear", "texture-wrap=mirror"},
           {"normals=triangle", "clipping=near", "texture-filter=mipmap"},
           {"lighting=off", "sample-position=corner", "backface-culling=off"},
           {"textures=off", "renormalise=off", "highlight=blinn-phong"}}) {
    Settings settings;
    settings.renderer = Renderer::rasterizer;
    for (const std::string& assignment : variant) parse_assignment(assignment, settings);
    settings.simd = Simd::off;
    const Frame clear = draw(scene, settings, 333, 211);
    const std::string what = (variant.empty() ? "defaults" : variant.front()) + ", seed " + std::to_string(seed);
    for (const Counter counter : {Counter::triangles_degenerate, Counter::triangles_split, Counter::depth_failures,
                                  Counter::triangles_clipped_away, Counter::pixels_written})
      EXPECT_GT(clear.counters[counter], 20u) << counter_key(counter) << ", " << what;
    EXPECT_FALSE(test::took_fast_frame(clear));
    for (const Simd simd : test::simd_targets())
      for (const int threads : {1, 2, 7}) {
        settings.simd = simd;
        settings.threads = threads;
        const Frame fast = draw(scene, settings, 333, 211);
        EXPECT_TRUE(test::took_fast_frame(fast)) << what;
        expect_equal(clear, fast, what + ", target " + std::to_string(static_cast<int>(simd)));
      }
  }
}

/// Pictures of every width: the last tile and the last vector of a row are seldom whole.
TEST(FastFrame, DrawsEveryWidth) {
  std::mt19937 random(7);
  const Scene scene = soup_scene(random);
  Settings settings;
  settings.renderer = Renderer::rasterizer;
  for (int width = 1; width < 140; width += width < 20 ? 1 : 7) {
    settings.simd = Simd::off;
    const Frame clear = draw(scene, settings, width, 66);
    settings.simd = Simd::automatic;
    EXPECT_TRUE(same_bits(clear.colour, draw(scene, settings, width, 66).colour)) << width;
  }
}

/// The levels that a caller asks for come with the tiles. Pictures too large for the cache are written past it, which
/// takes rows that begin where vectors may, and others.
TEST(FastFrame, GivesTheLevelsOfItsColours) {
  std::mt19937 random(11);
  const Scene scene = soup_scene(random);
  struct Size {
    int width, height;
  };
  const std::vector<std::string> displays{"exposure=1.7", "exposure=1", "gamma=2.2", "colour-depth=16"};
  Prepared prepared;
  for (const Size size : {Size{131, 70}, {640, 600}, {603, 640}})
    for (std::size_t choice = 0; choice < displays.size(); choice += test::list_step) {
      const std::string& display = displays[choice];
      Settings settings;
      settings.renderer = Renderer::rasterizer;
      parse_assignment(display, settings);
      settings.simd = Simd::off;
      const Frame clear = draw(scene, settings, size.width, size.height);
      for (const Simd simd : {Simd::off, Simd::sse4, Simd::automatic}) {
        settings.simd = simd;
        Image<Rgb8> levels(size.width, size.height, Rgb8{1, 2, 3});
        RenderRequest request;
        request.levels = &levels;
        Progress progress;
        const View view{scene.camera, size.width, size.height};
        const Frame fast = render(scene, view, settings, request, prepared, progress);
        EXPECT_TRUE(same_bits(clear.colour, fast.colour)) << size.width << " " << display;
        std::size_t different = 0;
        for (std::size_t i = 0; i < levels.pixels().size(); ++i)
          different +=
              levels.pixels()[i] != display_pixel(Vec3d(clear.colour.pixels()[i]), display_transform(settings));
        EXPECT_EQ(different, 0u) << size.width << " " << display;
      }
    }
}

/// A value of an option that the rasterizer's pictures or counters may depend on, cheap enough for a test.
void set_at_random(const Option& option, Settings& settings, std::mt19937& random) {
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  double value = option.minimum + (option.maximum - option.minimum) * share() * share();
  if (option.kind == OptionKind::boolean) value = share() < 0.5;
  if (option.kind == OptionKind::choice) value = std::floor(share() * static_cast<double>(option.choices.size()));
  if (option.kind == OptionKind::integer) value = std::floor(value);
  if (option.key == "tessellation") value = 0.3 + 3 * share();
  if (option.key == "shadow-map-size" || option.key == "environment-size") value = 8 + std::floor(24 * share());
  if (option.key == "near") value = 0.5 + share();
  option.set(settings, value);
}

/// Every option may take part, those that send a picture to the clear path too: who decides that must know all of them.
TEST(FastFrame, DrawsEveryScene) {
  const unsigned seed = test::test_seed(20261121);
  RecordProperty("seed", std::to_string(seed));
  SCOPED_TRACE("PIXELSCOPE_TEST_SEED=" + std::to_string(seed));
  std::mt19937 random(seed);
  const auto table = option_table();
  const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
  std::vector<Scene> scenes;
  for (const BuiltinScene& builtin : builtin_scenes()) scenes.push_back(load_scene(builtin.name));
  for (unsigned i = 0; i < 10; ++i) scenes.push_back(test::random_scene(seed + i));
  std::uint64_t batched = 0;
  for (std::size_t number = 0; number < scenes.size(); number += test::list_step)
    for (const std::size_t changes : {0, 1, 3}) {
      const Scene& scene = scenes[number];
      Settings settings = settings_for(scene);
      settings.renderer = Renderer::rasterizer;
      std::string what = scene.name;
      for (std::size_t i = 0; i < changes; ++i) {
        const Option& option = table[below(table.size())];
        if (option.key == "renderer" || option.key == "precision" || option.key == "simd") continue;
        set_at_random(option, settings, random);
        what += " " + std::string(option.key) + "=" + option_text(option, settings);
      }
      const int width = 90 + static_cast<int>(below(60)), height = 70 + static_cast<int>(below(20));
      settings.simd = Simd::off;
      const Frame clear = draw(scene, settings, width, height);
      constexpr std::array targets{Simd::sse4, Simd::avx2, Simd::avx512, Simd::automatic};
      for (const int threads : {1, 2, 7}) {
        settings.threads = threads;
        settings.simd = targets[below(targets.size())];
        const Frame fast = draw(scene, settings, width, height);
        expect_equal(clear, fast, what + ", simd " + std::to_string(static_cast<int>(settings.simd)));
        batched += test::took_fast_frame(fast) ? 1 : 0;
      }
      if (HasFailure()) return;
    }
  if (!test::simd_targets().empty()) {
    EXPECT_GT(batched, scenes.size() / test::list_step);
  }
}

}  // namespace
}  // namespace ps::fast_frame_test
