// Where a pixel has several samples, the story of a hardware pixel has the depth and the stencil of each: bit for bit
// those of the picture, which is drawn whole by other draws. The depths are also compared with the rasterizer's, which
// are those of the samples and not of the pixel's centre.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/environment.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::hardware_samples_test {
namespace {

constexpr int width = 160, height = 120, pixels_of_scene = 16;

struct Sampled {
  const char* scene;
  std::vector<std::string> assignments;
};
const std::vector<Sampled> cases{{"cgfs/crates", {}},
                                 {"cgfs/cubes", {"depth-format=unorm", "depth-bits=16"}},
                                 {"cgfs/depth", {"depth-format=unorm", "depth-bits=24", "early-depth=on"}},
                                 {"cgfs/depth", {"depth-value=distance"}},
                                 {"cgfs/shadows", {"shadows=stencil-depth-fail"}},
                                 {"octree/attenuation", {"shadows=stencil-depth-pass"}}};

/// "Sample 2 (not written): depth 0.5, stored 1, stencil 0", as the event lists those that the triangle covers.
struct SampleText {
  bool written = false;
  float depth = -1;
  std::optional<int> stencil;
};
std::map<int, SampleText> samples_in(const CoverageEvent& event) {
  std::map<int, SampleText> samples;
  std::size_t at = 0;
  while ((at = event.how.find("Sample ", at)) != std::string::npos) {
    const std::string text = event.how.substr(at, event.how.find(". S", at) - at);
    SampleText& sample = samples[std::stoi(text.substr(7))];
    sample.written = text.find("not written") == std::string::npos;
    if (const std::size_t depth = text.find(": depth "); depth != std::string::npos)
      sample.depth = std::stof(text.substr(depth + 8));
    if (const std::size_t stencil = text.find("stencil "); stencil != std::string::npos)
      sample.stencil = std::stoi(text.substr(stencil + 8));
    at += 7;
  }
  return samples;
}

/// What the driver holds of one pixel of a target.
struct Held {
  std::vector<float> depths;
  std::vector<int> stencils;
  bool operator==(const Held&) const = default;
};
Held held_by(hardware::Workshop& shop, const hardware::Framebuffer& target, Vec2i pixel) {
  Held held;
  held.depths = shop.sample_reader->depths(target, pixel).value_or(std::vector<float>{});
  if (target.shape().stencil) held.stencils = shop.sample_reader->stencils(target, pixel);
  return held;
}

TEST(HardwareSamples, HoldThePicturesDepthAndStencil) {
  PS_NEEDS_HARDWARE(hardware);
  const unsigned seed = test::test_seed(4);
  std::mt19937 random(seed);
  int depths_differ = 0, stencils_differ = 0, stencil_events = 0, compared = 0;
  for (const Sampled& one : cases) {
    const Scene scene = load_scene(one.scene);
    Settings settings = settings_for(scene, hardware);
    settings.multisampling = 4;
    for (const std::string& assignment : one.assignments) parse_assignment(assignment, settings);
    const View view{scene.camera, width, height};
    Prepared prepared;
    Progress progress;
    render(scene, view, settings, {}, prepared, progress);
    for (int i = 0; i < pixels_of_scene; ++i) {
      const int x = static_cast<int>(random() % width);
      const Vec2i pixel(x, static_cast<int>(random() % height));
      const std::string where = fmt::format("{} {},{} seed {}", one.scene, pixel.x, pixel.y, seed);
      const PixelStory story = inspect(scene, view, settings, pixel, prepared, progress);
      Held picture, story_held;
      hardware::on_gl_thread([&](hardware::Workshop& shop) {
        if (!shop.sample_reader) return;
        picture = held_by(shop, *shop.target, pixel);
        story_held = held_by(shop, *shop.story_picture, pixel);
      });
      if (picture.depths.empty()) continue;  // no triangle is near
      EXPECT_EQ(picture, story_held) << where;
      depths_differ += std::set(picture.depths.begin(), picture.depths.end()).size() > 1;
      std::map<int, float> last;
      std::set<int> stencils;
      for (const Event& event : story.events) {
        if (const auto* coverage = std::get_if<CoverageEvent>(&event.data))
          for (const auto& [sample, text] : samples_in(*coverage)) {
            if (text.written) last[sample] = text.depth;
            if (text.stencil) stencils.insert(*text.stencil);
          }
        const auto* stencil = std::get_if<StencilEvent>(&event.data);
        if (!stencil) continue;
        ++stencil_events;
        EXPECT_EQ(stencil->count & ((1 << settings.stencil_bits) - 1), stencil->stored) << where;
      }
      stencils_differ += stencils.size() > 1;
      for (const auto& [sample, depth] : last) {
        ++compared;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(depth),
                  std::bit_cast<std::uint32_t>(picture.depths.at(static_cast<std::size_t>(sample))))
            << where << " sample " << sample;
      }
    }
  }
  fmt::print("{} samples compared; depths differ within {} pixels, stencils within {}\n", compared, depths_differ,
             stencils_differ);
  EXPECT_GT(compared, 60);
  EXPECT_GT(depths_differ, 15) << "one value for all samples would do";
  EXPECT_GT(stencils_differ, 0);
  EXPECT_GT(stencil_events, 10);
}

/// The first depth that a triangle brings, and what it is compared with.
std::map<int, std::pair<double, double>> first_depths(const PixelStory& story) {
  std::map<int, std::pair<double, double>> depths;  // by triangle
  for (const auto* fragment : events_of<FragmentEvent>(story.events))
    if (fragment->samples_covered == fragment->samples && fragment->depth_new && fragment->depth_stored)
      depths[fragment->id.object * 1000 + fragment->id.triangle] = {*fragment->depth_new, *fragment->depth_stored};
  return depths;
}

/// The means of what several triangles show would differ at edges by as much as the triangles do.
TEST(HardwareSamples, ChannelsAreThoseOfTheFirstSample) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* name : {"cgfs/crates", "cgfs/shading"}) {
    const Scene scene = load_scene(name);
    Settings settings = settings_with(settings_for(scene), {"multisampling=4", "shadows=none", "vertex-snapping=cpu"});
    settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
    RenderRequest request;
    request.channels = Channel::ids | Channel::depth | Channel::normal | Channel::uv | Channel::barycentric;
    const View view{scene.camera, width, height};
    settings.renderer = Renderer::rasterizer;
    const Frame expected = render(scene, view, settings, request);
    settings.renderer = hardware;
    const Frame drawn = render(scene, view, settings, request);
    long seen = 0, edges = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::string where = fmt::format("{} {},{}", name, x, y);
        const PixelId id = expected.ids.at(x, y);
        EXPECT_EQ(id, drawn.ids.at(x, y)) << where;
        if (id.object < 0 || id != drawn.ids.at(x, y)) continue;
        ++seen;
        edges += (x > 0 && expected.ids.at(x - 1, y) != id) || (y > 0 && expected.ids.at(x, y - 1) != id);
        EXPECT_NEAR(expected.depth.at(x, y), drawn.depth.at(x, y), 1e-4 * expected.depth.at(x, y)) << where;
        EXPECT_LT(length(expected.normal.at(x, y) - drawn.normal.at(x, y)), 1e-3f) << where;
        const auto apart = [&](const Image<Vec2f>& a, const Image<Vec2f>& b) {
          return std::max(std::abs(a.at(x, y).x - b.at(x, y).x), std::abs(a.at(x, y).y - b.at(x, y).y));
        };
        EXPECT_LT(apart(expected.uv, drawn.uv), 2e-3f) << where;
        const Vec3f weights = expected.barycentric.at(x, y) - drawn.barycentric.at(x, y);
        EXPECT_LT(length(weights), 5e-3f) << where;
      }
    EXPECT_GT(seen, 1000) << name;
    EXPECT_GT(edges, 100) << name;
  }
}

TEST(HardwareSamples, HaveTheRasterizersDepths) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene scene = load_scene("cgfs/depth");
  Settings a = settings_with(settings_for(scene), {"multisampling=4", "depth-format=unorm", "depth-bits=24"});
  Settings b = a;
  a.renderer = Renderer::rasterizer;
  a.subpixel_bits = hardware::availability().driver->subpixel_bits;
  b.renderer = hardware;
  const View view{scene.camera, width, height};
  Prepared prepared;
  Progress progress;
  constexpr double codes = 0xffffff;  // the rasterizer reports whole numbers, a driver shares of the largest
  int compared = 0, stored = 0;
  double farthest = 0;
  for (int y = 3; y < height; y += 6)
    for (int x = 3; x < width; x += 6) {
      const auto ours = first_depths(inspect(scene, view, a, {x, y}, prepared, progress));
      for (const auto& [triangle, theirs] : first_depths(inspect(scene, view, b, {x, y}, prepared, progress))) {
        const auto own = ours.find(triangle);
        if (own == ours.end()) continue;
        ++compared;
        farthest = std::max(farthest, std::abs(own->second.first / codes - theirs.first));
        if (std::isinf(own->second.second)) continue;  // nothing is stored yet
        ++stored;
        farthest = std::max(farthest, std::abs(own->second.second / codes - theirs.second));
      }
    }
  fmt::print("{} fragments, {} before others, depths at most {:.3g} apart\n", compared, stored, farthest);
  EXPECT_GT(compared, 50);
  EXPECT_GT(stored, 5);
  EXPECT_LT(farthest, 100 / codes) << "from a sample to the next they differ by thousands of codes";
}

}  // namespace
}  // namespace ps::hardware_samples_test
