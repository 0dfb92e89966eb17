// The story of a hardware pixel is what the driver did: at random pixels its last colour and depth are the picture's,
// bit for bit. The picture is drawn whole by its own programs; the story asks other programs, triangle by triangle.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "base/timer.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::hardware_story_test {
namespace {

constexpr int width = 240, height = 180;

/// 1,000 in all. PIXELSCOPE_STORY_PIXELS asks for more of each case, PIXELSCOPE_TEST_SEED for others. Half of them are
/// drawn from those that show a surface.
int pixels_of_scene() { return static_cast<int>(test::number_from("PIXELSCOPE_STORY_PIXELS", 50)); }
unsigned seed() { return test::test_seed(21); }

struct StoryCase {
  const char* scene;
  std::vector<std::string> assignments;
  std::string name() const { return fmt::format("{} {}", scene, fmt::join(assignments, " ")); }
};

const std::vector<StoryCase> cases{
    {"cgfs/shading", {}},
    {"cgfs/shadows", {"shadows=stencil-depth-fail"}},
    {"octree/attenuation", {"shadows=stencil-depth-pass", "deferred-shading=on"}},
    {"lab/inside-shadow", {"shadows=map", "shadow-filter=3"}},
    {"octree/attenuation", {"shadows=map", "shading=gouraud"}},
    {"cgfs/crates", {"multisampling=4"}},
    {"cgfs/shadows", {"multisampling=4", "shadows=stencil-depth-fail"}},
    {"cgfs/reflections", {"environment=cube-map", "deferred-shading=on"}},
    {"cgfs/reflections", {"environment=cube-map"}},
    {"cgfs/relief", {}},
    {"cgfs/fence", {"texture-filter=mipmap", "early-depth=on"}},
    {"cgpp/teapot", {"shading=gouraud"}},
    {"octree/headline", {"shading=flat"}},
    {"lab/cornell", {"light-passes=many"}},
    {"lab/hierarchy", {"visibility=painter"}},
    {"cgfs/cubes", {"depth-format=unorm", "depth-bits=16"}},
    {"cgfs/depth", {"depth-value=distance", "interpolation=affine"}},
    {"cgfs/behind", {"vertex-snapping=cpu", "backface-culling=off"}},
    {"cgfs/brick-wall", {"hardware-texturing=driver", "projection=orthographic"}},
    {"cgfs/wireframe", {}},
};

std::array<std::uint32_t, 3> bits(const Vec3d& colour) {
  const Vec3f rounded(colour);
  return {std::bit_cast<std::uint32_t>(rounded.x), std::bit_cast<std::uint32_t>(rounded.y),
          std::bit_cast<std::uint32_t>(rounded.z)};
}
std::uint32_t bits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

Vec2i any_pixel(std::mt19937& random) {
  const int x = static_cast<int>(random() % width);
  return {x, static_cast<int>(random() % height)};
}

std::vector<Vec2i> pixels_with_surface(const Frame& seen) {
  std::vector<Vec2i> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (seen.ids.at(x, y).object >= 0) pixels.emplace_back(x, y);
  return pixels;
}

/// The last write, and the fragment that it belongs to.
struct LastWrite {
  const WriteEvent* write = nullptr;
  const FragmentEvent* fragment = nullptr;
};
LastWrite last_write(const PixelStory& story) {
  LastWrite last;
  for (const Event& event : story.events)
    if (const auto* write = std::get_if<WriteEvent>(&event.data)) {
      last.write = write;
      last.fragment = event.parent < 0
                          ? nullptr
                          : std::get_if<FragmentEvent>(&story.events[static_cast<std::size_t>(event.parent)].data);
    }
  return last;
}

bool nearly_equal(const Vec3d& a, const Vec3d& b) {
  const Vec3d difference = abs(a - b);
  return std::max({difference.x, difference.y, difference.z}) < 0x1p-22;
}

/// Each write brings what the story's program says that it shades. A driver may round the interpolation of the two
/// programs differently (llvmpipe of Mesa 25 does), by no more than a float near 1.
void expect_writes_as_shaded(const PixelStory& story, const std::string& where) {
  for (const auto* write : events_of<WriteEvent>(story.events)) {
    if (write->id.object < 0) continue;
    const bool replaces = nearly_equal(write->after, write->shaded);
    const bool adds = nearly_equal(write->after, write->before + write->shaded);
    EXPECT_TRUE(replaces || adds) << where;
  }
}

/// The faces of shadow volumes that it reports make what the stencil buffer holds.
int expect_stencil_as_counted(const PixelStory& story, int stencil_bits, const std::string& where) {
  int counted = 0;
  for (const auto* stencil : events_of<StencilEvent>(story.events)) {
    EXPECT_EQ(stencil->count & ((1 << stencil_bits) - 1), stencil->stored) << where;
    counted += stencil->crossings.empty() ? 0 : 1;
  }
  return counted;
}

TEST(HardwareStory, EndsWithThePicturesColourAndDepth) {
  PS_NEEDS_HARDWARE(hardware);
  const int count = pixels_of_scene();
  double slowest = 0, total = 0;
  long stories = 0;
  for (const StoryCase& one : cases) {
    SCOPED_TRACE(one.name());
    const Scene scene = load_scene(one.scene);
    Settings settings = settings_with(settings_for(scene, hardware), one.assignments);
    const View view{scene.camera, width, height};
    Prepared prepared;
    Progress progress;
    const Frame seen = render(scene, view, settings, request_for(Channel::ids | Channel::depth | Channel::barycentric),
                              prepared, progress);
    const Frame frame = render(scene, view, settings, {}, prepared, progress);
    const std::vector<Vec2i> surfaces = pixels_with_surface(seen);
    ASSERT_FALSE(surfaces.empty());
    std::mt19937 random(seed());
    std::set<std::array<std::uint32_t, 3>> colours;
    int written = 0, counted = 0;
    for (int i = 0; i < count; ++i) {
      const Vec2i pixel = i % 2 == 0 ? any_pixel(random) : surfaces.at(random() % surfaces.size());
      const std::string where = fmt::format("pixel {},{}", pixel.x, pixel.y);
      const Timer timer;
      const PixelStory story = inspect(scene, view, settings, pixel, prepared, progress);
      total += timer.milliseconds();
      slowest = std::max(slowest, timer.milliseconds());
      ++stories;
      EXPECT_EQ(bits(story.linear), bits(Vec3d(frame.colour.at(pixel.x, pixel.y)))) << where;
      colours.insert(bits(story.linear));
      const LastWrite last = last_write(story);
      const bool shows = seen.ids.at(pixel.x, pixel.y).object >= 0;  // with several samples, the first of them
      EXPECT_TRUE(last.write || !shows) << where;
      if (settings.multisampling > 1) {
        written += last.write != nullptr;
        continue;
      }
      EXPECT_TRUE(shows || !last.write) << where;
      hardware::on_gl_thread([&](hardware::Workshop& shop) {
        EXPECT_EQ(bits(static_cast<double>(shop.story_picture->read_depth(pixel))),
                  bits(static_cast<double>(shop.target->read_depth(pixel))))
            << where;
      });
      if (!last.write) continue;
      ++written;
      EXPECT_EQ(bits(last.write->after), bits(story.linear)) << where;
      expect_writes_as_shaded(story, where);
      counted += expect_stencil_as_counted(story, settings.stencil_bits, where);
      ASSERT_TRUE(last.fragment) << where;
      EXPECT_EQ(last.fragment->id, seen.ids.at(pixel.x, pixel.y)) << where;
      EXPECT_EQ(bits(last.fragment->z), std::bit_cast<std::uint32_t>(seen.depth.at(pixel.x, pixel.y))) << where;
      if (last.fragment->sphere_triangle >= 0) continue;
      const Vec3f weights = seen.barycentric.at(pixel.x, pixel.y);
      EXPECT_EQ(std::max(static_cast<float>(last.fragment->weights[0]), 0.0f), weights.x) << where;
      EXPECT_EQ(std::max(static_cast<float>(last.fragment->weights[1]), 0.0f), weights.y) << where;
    }
    fmt::print("{}: {} of {} pixels show a surface, {} colours, {} stencil counts, seed {}\n", one.name(), written,
               count, colours.size(), counted, seed());
    EXPECT_GE(written, count / 2);
  }
  fmt::print("{} stories, {:.1f} ms each, {:.1f} ms the slowest\n", stories, total / static_cast<double>(stories),
             slowest);
}

// The program of a deferred pass knows no triangle: the weights are those of the pass that found it.
TEST(HardwareStory, WeighsTheLightOfVerticesAlsoDeferred) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/shading");
  Settings settings = settings_for(scene, hardware);
  settings.shading = Shading::gouraud;
  settings.deferred_shading = true;
  const View view{scene.camera, 60, 60};
  Prepared prepared;
  Progress progress;
  PixelStory story;
  for (int y = 0; y < view.height && !last_write(story).fragment; ++y)
    story = inspect(scene, view, settings, {30, y}, prepared, progress);
  ASSERT_TRUE(last_write(story).fragment);
  Vec3d light{0}, weights{0};
  for (const auto* vertex : events_of<VertexLightEvent>(story.events)) {
    ASSERT_TRUE(vertex->vertex);
    weights[*vertex->vertex] = vertex->weight;
    light += vertex->weight * vertex->light;
  }
  for (int k = 0; k < 3; ++k) EXPECT_EQ(weights[k], last_write(story).fragment->weights[static_cast<std::size_t>(k)]);
  EXPECT_NEAR(weights.x + weights.y + weights.z, 1, 1e-6);
  double shaded = 0;
  for (const auto* shade : events_of<ShadeEvent>(story.events)) shaded = shade->light.x;
  EXPECT_GT(shaded, 0);
  EXPECT_NEAR(light.x, shaded, 1e-5);
}

/// The samples of the last write that were written, and how many there are.
std::pair<int, int> samples_written(const PixelStory& story) {
  std::pair<int, int> samples{0, 0};
  for (const auto* coverage : events_of<CoverageEvent>(story.events))
    samples = {static_cast<int>(coverage->values.size()), coverage->tests};
  return samples;
}

// One triangle before a background: the picture's colour itself holds how many samples it covers.
TEST(HardwareStory, CountsTheSamplesThatThePictureMixes) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgpp/triangle");
  Settings settings = settings_for(scene, hardware);
  settings.multisampling = 4;
  const View view{scene.camera, 40, 40};
  Prepared prepared;
  Progress progress;
  const Frame frame = render(scene, view, settings, {}, prepared, progress);
  std::array<int, 5> pixels{};  // by samples
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      const PixelStory story = inspect(scene, view, settings, {x, y}, prepared, progress);
      const LastWrite last = last_write(story);
      const auto [written, all] = samples_written(story);
      ++pixels.at(static_cast<std::size_t>(written));
      Vec3d mixed = scene.background;
      if (written > 0) mixed += (last.write->shaded - scene.background) * (static_cast<double>(written) / all);
      EXPECT_NEAR(glm::length(mixed - Vec3d(frame.colour.at(x, y))), 0, 1e-5)
          << written << " of " << all << " samples, pixel " << x << "," << y;
    }
  for (const int count : pixels) EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace ps::hardware_story_test
