// Random scenes under random options, drawn again in every way that may not change a bit: on each SIMD target, with
// more threads, with another accelerator, in part, and pixel by pixel by the inspector. PIXELSCOPE_TEST_SEED repeats a
// run, PIXELSCOPE_FUZZ_SECONDS lengthens it; `tests/run --fuzz` does. Then a quarter of the scenes hold extreme
// numbers. Another quarter is without casters, lights or objects, and an eighth of the pictures has an extreme size.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "frame/display_frame.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/bare_scene.h"
#include "support/environment.h"
#include "support/hostile_scene.h"
#include "support/random_scene.h"
#include "support/random_settings.h"
#include "support/simd_targets.h"

namespace ps::differential_test {
namespace {

using Random = std::mt19937;
using test::below;
using test::share;

constexpr Channel compared_channels =
    Channel::depth | Channel::normal | Channel::barycentric | Channel::uv | Channel::ids | Channel::facing;

/// A scene with its settings, and the words by which a failure names it.
struct Subject {
  Scene scene;
  View view;
  Settings settings;
  Channel channels = Channel::none;
  std::string words;
};

bool same_number(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}
bool same_number(const PixelId& a, const PixelId& b) { return a == b; }
template <int n>
bool same_number(const glm::vec<n, float>& a, const glm::vec<n, float>& b) {
  for (int i = 0; i < n; ++i)
    if (!same_number(a[i], b[i])) return false;
  return true;
}

/// The first pixel of `region` in which two pictures differ in a bit; any NaN equals any.
template <class T>
std::optional<Vec2i> difference(const Image<T>& a, const Image<T>& b, const TileRect& region) {
  if (a.empty() != b.empty()) return Vec2i(-1, -1);
  if (a.empty()) return {};
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x)
      if (!same_number(a.at(x, y), b.at(x, y))) return Vec2i(x, y);
  return {};
}

std::string fault_between(const Frame& a, const Frame& b, const TileRect& region) {
  const auto fault = [&](const char* name, const std::optional<Vec2i>& pixel) {
    return pixel ? fmt::format("{} differs at {},{}", name, pixel->x, pixel->y) : std::string();
  };
  for (const std::string& found :
       {fault("colour", difference(a.colour, b.colour, region)), fault("depth", difference(a.depth, b.depth, region)),
        fault("normal", difference(a.normal, b.normal, region)),
        fault("barycentric", difference(a.barycentric, b.barycentric, region)),
        fault("uv", difference(a.uv, b.uv, region)), fault("ids", difference(a.ids, b.ids, region)),
        fault("facing", difference(a.facing, b.facing, region))})
    if (!found.empty()) return found;
  return {};
}

Frame drawn(const Subject& subject, const Settings& settings, const std::optional<TileRect>& region = {}) {
  Prepared prepared;
  Progress progress;
  RenderRequest request;
  request.channels = subject.channels;
  request.region = region;
  return render(subject.scene, subject.view, settings, request, prepared, progress);
}

Settings random_settings(const Scene& scene, Random& random) {
  Settings settings = settings_for(scene);
  const double density = share(random) * 0.25;
  for (const Option& option : option_table())
    if (share(random) < density) option.set(settings, test::random_value(option, random));
  // Six pictures of every mirror and light, made anew for each way to draw: at their usual size one scene with thirty
  // mirrors would take a minute, and their pixels come from the same code as all others.
  settings.environment_size = std::min(settings.environment_size, 24);
  settings.shadow_map_size = std::min(settings.shadow_map_size, 64);
  settings.renderer = below(random, 5) == 0   ? Renderer::textbook
                      : below(random, 2) == 0 ? Renderer::ray_tracer
                                              : Renderer::rasterizer;
  return settings;
}

enum class Numbers { moderate, extreme_too };

std::optional<Subject> random_subject(Random& random, Numbers numbers) {
  Subject subject;
  if (numbers == Numbers::extreme_too && below(random, 4) == 0) {
    auto hostile = test::hostile_scene(random);
    if (!hostile) return {};
    subject.scene = std::move(hostile->scene);
    subject.words = "scene\n" + hostile->text;
  } else {
    const unsigned seed = static_cast<unsigned>(random() % 1000000);
    subject.scene = test::random_scene(seed);
    subject.words = fmt::format("random_scene({})", seed);
  }
  if (below(random, 4) == 0) {
    const test::Bare what = test::all_bare[static_cast<std::size_t>(below(random, int(test::all_bare.size())))];
    subject.scene = test::bare_scene(std::move(subject.scene), what);
    subject.words += std::string(" ") + std::string(test::bare_name(what));
  }
  subject.view = {subject.scene.camera, 16 + below(random, 33), 12 + below(random, 25)};
  if (below(random, 8) == 0) {  // a picture of a few pixels, or of one row or column
    subject.view.width = below(random, 2) == 0 ? 1 + below(random, 3) : 1 + below(random, 600);
    subject.view.height = 1 + below(random, 3);
    if (below(random, 2) == 0) std::swap(subject.view.width, subject.view.height);
  }
  try {
    subject.settings = random_settings(subject.scene, random);
  } catch (const InputError&) {  // an extreme number among the scene's own settings
    return {};
  }
  if (below(random, 2) == 0) subject.channels = compared_channels;
  subject.words += fmt::format("\n{}x{}, channels {},{}", subject.view.width, subject.view.height,
                               static_cast<unsigned>(subject.channels), test::changed_settings(subject.settings));
  return subject;
}

/// Another accelerator that must find the same. Embree's own arithmetic may part at edges, and the naive slab test
/// loses boxes, as its help says.
Accelerator another_accelerator(const Settings& settings, Random& random) {
  constexpr std::array all{Accelerator::none, Accelerator::bvh,    Accelerator::bounding_spheres,
                           Accelerator::box,  Accelerator::octree, Accelerator::two_level};
  if (settings.accelerator == Accelerator::embree || settings.slab_test == SlabTest::naive) return settings.accelerator;
  return all[static_cast<std::size_t>(below(random, static_cast<int>(all.size())))];
}

TileRect random_region(const View& view, Random& random) {
  const int x = below(random, view.width), y = below(random, view.height);
  return {x, y, x + 1 + below(random, view.width - x), y + 1 + below(random, view.height - y)};
}

/// Draws the subject in every way; the words of the first fault, or nothing.
std::string fault_of(const Subject& subject, Random& random) {
  const TileRect all{0, 0, subject.view.width, subject.view.height};
  Settings plain = subject.settings;
  plain.simd = Simd::off;
  plain.threads = 1;
  const Frame base = drawn(subject, plain);
  std::vector<Simd> targets = test::simd_targets();
  targets.push_back(Simd::off);
  for (const Simd target : targets) {
    Settings other = subject.settings;
    other.simd = target;
    other.threads = 1 + below(random, 7);
    other.accelerator = another_accelerator(subject.settings, random);
    const std::string fault = fault_between(base, drawn(subject, other), all);
    if (!fault.empty()) return fault + ", with" + test::changed_settings(other);
  }
  const TileRect region = random_region(subject.view, random);
  const std::string fault = fault_between(base, drawn(subject, subject.settings, region), region);
  if (!fault.empty())
    return fmt::format("{} in the region {},{} {}x{}", fault, region.x0, region.y0, region.width(), region.height());
  const Vec2i pixel(below(random, subject.view.width), below(random, subject.view.height));
  Prepared prepared;
  Progress progress;
  const PixelStory story = inspect(subject.scene, subject.view, subject.settings, pixel, prepared, progress);
  const Vec3d stored = linear_at(base, pixel);
  for (int i = 0; i < 3; ++i)
    if (story.linear[i] != stored[i] && !(std::isnan(story.linear[i]) && std::isnan(stored[i])))
      return fmt::format("the inspector has {} for {} in channel {} at {},{}", story.linear[i], stored[i], i, pixel.x,
                         pixel.y);
  return {};
}

/// A fault that this test was made to find: eye rays through another place of the pixel.
TEST(Differential, FindsAPlantedDifference) {
  Random random(1);
  int found = 0;
  for (int i = 0; i < 10; ++i) {
    const auto subject = random_subject(random, Numbers::moderate);
    if (!subject) continue;
    Settings other = subject->settings;
    other.sample_position =
        other.sample_position == SamplePosition::centre ? SamplePosition::corner : SamplePosition::centre;
    const TileRect all{0, 0, subject->view.width, subject->view.height};
    found += fault_between(drawn(*subject, subject->settings), drawn(*subject, other), all).empty() ? 0 : 1;
  }
  EXPECT_GT(found, 2) << "of ten scenes";
}

TEST(Differential, EveryWayToDrawAPictureGivesTheSameBits) {
  const unsigned seed = test::test_seed();
  const bool longer = std::getenv("PIXELSCOPE_FUZZ_SECONDS") != nullptr;
  const std::chrono::duration<double> time(test::number_from("PIXELSCOPE_FUZZ_SECONDS", 4));
  Random random(seed);
  int pictures = 0, refused = 0;
  const auto start = std::chrono::steady_clock::now();
  while (pictures < 5 || std::chrono::steady_clock::now() - start < time) {
    const auto subject = random_subject(random, longer ? Numbers::extreme_too : Numbers::moderate);
    if (!subject) {
      ++refused;
      continue;
    }
    std::string fault;
    try {
      fault = fault_of(*subject, random);
    } catch (const InputError&) {  // numbers that cannot be drawn, such as a camera's axes in one plane
      ++refused;
      continue;
    }
    ++pictures;
    ASSERT_EQ(fault, "") << "PIXELSCOPE_TEST_SEED=" << seed << ", picture " << pictures << ": " << subject->words;
  }
  std::cout << "PIXELSCOPE_TEST_SEED=" << seed << ": " << pictures << " scenes, " << refused << " refused\n";
}

}  // namespace
}  // namespace ps::differential_test
