// Scenes and options drawn again in every way that may not change a bit: on each SIMD target, with more threads, with
// another accelerator, in part, and pixel by pixel by the inspector. Fixed lists go through each value of each option,
// the scenes that Pixelscope ships with and the triangles that fast paths treat apart. Then random scenes under random
// options: PIXELSCOPE_TEST_SEED repeats a run, PIXELSCOPE_FUZZ_SECONDS lengthens it; `tests/run --fuzz` does. Then a
// quarter of the scenes hold extreme numbers. Another quarter is without casters, lights or objects, and an eighth of
// the pictures has an extreme size.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <regex>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/enumerators.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/bare_scene.h"
#include "support/differential.h"
#include "support/environment.h"
#include "support/random_scene.h"
#include "support/random_settings.h"
#include "support/simd_targets.h"
#include "support/trials.h"
#include "support/triangle_soup.h"

namespace ps::differential_test {
namespace {

using Random = std::mt19937;
using test::below;
using test::share;
using test::Subject;

struct Source {
  std::string text, folder;
};

/// Scenes whose cost does not lie in their models, which would take seconds each.
const std::vector<Source>& sources() {
  static const std::vector<Source> all = [] {
    std::vector<Source> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("assets/scenes")) {
      if (entry.path().extension() != ".scene") continue;
      Source source{read_whole_file(entry.path()), entry.path().parent_path().string()};
      if (source.text.find("generator") == std::string::npos && source.text.find("file") == std::string::npos &&
          source.text.find("include") == std::string::npos)
        found.push_back(std::move(source));
    }
    std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.text < b.text; });
    return found;
  }();
  return all;
}

/// A built-in scene's file in which one to four numbers are replaced by extreme ones (5e-324, 1e12, -1 and the like),
/// and its text; nothing where the result is refused.
struct HostileScene {
  Scene scene;
  std::string text;
};
std::optional<HostileScene> hostile_scene(Random& random) {
  static constexpr std::array<const char*, 14> extremes{"0",    "-0", "5e-324", "-5e-324", "1e-300", "1e-162", "1e-20",
                                                        "1e-8", "-1", "1",      "1e5",     "1e12",   "-1e12",  "1e30"};
  const Source& source = sources()[static_cast<std::size_t>(below(random, static_cast<int>(sources().size())))];
  std::string text = source.text;
  static const std::regex number(R"((^|[\s=(,])(-?[0-9]+\.?[0-9]*)(?=[\s,)]|$))");
  for (int changes = 1 + below(random, 4); changes > 0; --changes) {
    const std::vector<std::smatch> places(std::sregex_iterator(text.begin(), text.end(), number), {});
    if (places.empty()) break;
    const std::smatch& place = places[static_cast<std::size_t>(below(random, static_cast<int>(places.size())))];
    const auto at = static_cast<std::size_t>(place.position(2)), length = static_cast<std::size_t>(place.length(2));
    text = text.substr(0, at) + extremes[static_cast<std::size_t>(below(random, static_cast<int>(extremes.size())))] +
           text.substr(at + length);
  }
  try {
    return HostileScene{parse_scene(text, "hostile.scene", source.folder), text};
  } catch (const InputError&) {
    return {};
  }
}

/// Six pictures of every mirror and light, made anew for each way to draw: at their usual size one scene with thirty
/// mirrors would take a minute, and their pixels come from the same code as all others.
void keep_maps_small(Settings& settings) {
  settings.environment_size = std::min(settings.environment_size, 24);
  settings.shadow_map_size = std::min(settings.shadow_map_size, 64);
}

/// None; those that the window always asks for, which fast paths store; or all that a pixel has.
Channel random_channels(Random& random) {
  const int choice = below(random, 3);
  return choice == 0 ? Channel::none : choice == 1 ? Channel::ids | Channel::depth : test::pixel_channels;
}

void name_settings(Subject& subject) {
  subject.words += fmt::format("\n{}x{}, channels {},{}", subject.view.width, subject.view.height,
                               static_cast<unsigned>(subject.channels), test::changed_settings(subject.settings));
}

Settings random_settings(const Scene& scene, Random& random) {
  Settings settings = settings_for(scene);
  const double density = share(random) * 0.25;
  for (const Option& option : option_table())
    if (share(random) < density) option.set(settings, test::random_value(option, random));
  keep_maps_small(settings);
  settings.renderer = below(random, 5) == 0   ? Renderer::textbook
                      : below(random, 2) == 0 ? Renderer::ray_tracer
                                              : Renderer::rasterizer;
  return settings;
}

enum class Numbers { moderate, extreme_too };

std::optional<Subject> random_subject(Random& random, Numbers numbers) {
  Subject subject;
  Scene scene;
  if (numbers == Numbers::extreme_too && below(random, 4) == 0) {
    auto hostile = hostile_scene(random);
    if (!hostile) return {};
    scene = std::move(hostile->scene);
    subject.words = "scene\n" + hostile->text;
  } else {
    const unsigned seed = static_cast<unsigned>(random() % 1000000);
    scene = test::random_scene(seed);
    subject.words = fmt::format("random_scene({})", seed);
  }
  if (below(random, 4) == 0) {
    const test::Bare what =
        all_enumerators<test::Bare>[static_cast<std::size_t>(below(random, int(all_enumerators<test::Bare>.size())))];
    scene = test::bare_scene(std::move(scene), what);
    subject.words += std::string(" ") + std::string(enumerator_key(what));
  }
  subject.scene = std::make_shared<const Scene>(std::move(scene));
  subject.view = {subject.scene->camera, 16 + below(random, 33), 12 + below(random, 25)};
  if (below(random, 8) == 0) {  // a picture of a few pixels, or of one row or column
    subject.view.width = below(random, 2) == 0 ? 1 + below(random, 3) : 1 + below(random, 600);
    subject.view.height = 1 + below(random, 3);
    if (below(random, 2) == 0) std::swap(subject.view.width, subject.view.height);
  }
  try {
    subject.settings = random_settings(*subject.scene, random);
  } catch (const InputError&) {  // an extreme number among the scene's own settings
    return {};
  }
  subject.channels = random_channels(random);
  name_settings(subject);
  return subject;
}

/// What drew the pictures of a list: a list that no fast path takes proves nothing.
class Paths {
 public:
  test::SeenPaths seen;
  auto by(Machinery machinery) const {
    return std::ranges::count_if(seen, [&](const FastPath& path) { return path.machinery == machinery; });
  }
  auto shaded_together() const {
    return std::ranges::count_if(seen, [](const FastPath& path) {
      return path.machinery == Machinery::wide_triangles && path.shading != SurfaceShading::single;
    });
  }
};

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
    found += test::picture_difference(drawn(*subject, subject->settings), drawn(*subject, other), all).empty() ? 0 : 1;
  }
  EXPECT_GT(found, 2) << "of ten scenes";
}

/// Spheres alone, plain triangles and textured ones, each value of a choice and two of a number.
TEST(Differential, EachValueOfEachOption) {
  Random random(5);
  Paths paths;
  for (const char* name : {"cgfs/reflections", "cgfs/shading", "cgfs/crates"}) {
    const auto scene = std::make_shared<const Scene>(load_scene(name));
    const auto prepared = std::make_shared<Prepared>();
    const auto options = option_table();
    for (std::size_t number = 0; number < options.size(); number += test::list_step) {
      const Option& option = options[number];
      const bool listed = option.kind == OptionKind::boolean || option.kind == OptionKind::choice;
      const int values = option.kind == OptionKind::boolean  ? 2
                         : option.kind == OptionKind::choice ? static_cast<int>(option.choices.size())
                                                             : 2;
      for (int value = 0; value < values; ++value)
        for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
          if (option.key == "renderer") continue;
          Subject subject{scene, prepared, {scene->camera, 41 + value, 27}, settings_for(*scene), Channel::none, name};
          subject.settings.renderer = renderer;
          option.set(subject.settings, listed ? value : test::random_value(option, random));
          keep_maps_small(subject.settings);
          subject.channels = random_channels(random);
          name_settings(subject);
          ASSERT_EQ(test::differential_fault(subject, random, paths.seen, test::Targets::one), "") << subject.words;
        }
    }
  }
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target: both sides are the clear path";
  for (const Machinery machinery :
       {Machinery::sphere_packets, Machinery::wide_triangles, Machinery::fragment_batches, Machinery::whole_frame})
    EXPECT_GT(paths.by(machinery), 10 / static_cast<int>(test::list_step)) << machinery_key(machinery);
  EXPECT_GT(paths.shaded_together(), 10 / static_cast<int>(test::list_step)) << "hits of eight rays shaded together";
}

/// Each scene as it ships, from elsewhere and under options drawn at random: those that send a picture to the clear
/// path too, since who decides that must know all of them.
TEST(Differential, EachSceneFromAnywhere) {
  Random random(20261121);
  Paths paths;
  const std::vector<BuiltinScene>& scenes = builtin_scenes();
  for (std::size_t number = 0; number < scenes.size(); number += test::list_step) {
    const auto scene = std::make_shared<const Scene>(load_scene(scenes[number].name));
    const auto prepared = std::make_shared<Prepared>();
    for (const int changes : {0, 1, 3})
      for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
        Subject subject{scene, prepared, {scene->camera, 75, 49}, settings_for(*scene), Channel::none, scene->name};
        if (changes > 0) {  // turned, its axes neither orthogonal nor of unit length
          const auto vector = [&] { return Vec3d(share(random), share(random), share(random)) - Vec3d(0.5); };
          subject.view.camera.right += vector();
          subject.view.camera.up += vector();
          subject.view.camera.forward += vector();
          subject.view.camera.position += (share(random) * 3 - 1) * scene->camera.forward;
          subject.view.width += below(random, 60);
        }
        const auto options = option_table();
        for (int i = 0; i < changes; ++i) {
          const Option& option = options[static_cast<std::size_t>(below(random, static_cast<int>(options.size())))];
          option.set(subject.settings, test::random_value(option, random));
        }
        subject.settings.renderer = renderer;
        if (test::is_large(*scene) && subject.settings.accelerator != Accelerator::octree)
          subject.settings.accelerator = Accelerator::bvh;
        keep_maps_small(subject.settings);
        subject.channels = random_channels(random);
        name_settings(subject);
        ASSERT_EQ(test::differential_fault(subject, random, paths.seen, test::Targets::one), "") << subject.words;
      }
  }
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target: both sides are the clear path";
  for (const Machinery machinery : {Machinery::sphere_packets, Machinery::wide_triangles, Machinery::whole_frame})
    EXPECT_GT(paths.by(machinery), 10 / static_cast<int>(test::list_step)) << machinery_key(machinery);
}

TEST(Differential, TrianglesOfEveryKind) {
  constexpr unsigned seed = 20240;
  RecordProperty("seed", seed);
  Random random(seed);
  Paths paths;
  const auto scene = std::make_shared<const Scene>(test::triangle_soup(random));
  const auto prepared = std::make_shared<Prepared>();
  for (const std::vector<std::string>& variant : std::vector<std::vector<std::string>>{
           {},
           {"backface-culling=off"},
           {"fill-rule=inclusive", "subpixel-bits=4", "texture-filter=nearest"},
           {"fill-rule=exclusive", "subpixel-bits=0", "texture-filter=bilinear", "texture-wrap=mirror"},
           {"normals=triangle", "clipping=near", "texture-filter=mipmap"},
           {"shading=gouraud", "depth-value=z", "texture-filter=trilinear", "mip-bias=3.5"},
           {"lighting=off", "sample-position=corner", "backface-culling=off"},
           {"textures=off", "renormalise=off", "highlight=blinn-phong"}})
    for (const Channel channels : {Channel::none, Channel::ids | Channel::depth})
      for (const Renderer renderer : {Renderer::rasterizer, Renderer::ray_tracer}) {
        Subject subject{scene, prepared, {scene->camera, 333, 211}, {}, channels, "soup"};
        if (renderer == Renderer::ray_tracer) subject.view.width = 75, subject.view.height = 49;
        for (const std::string& assignment : variant) parse_assignment(assignment, subject.settings);
        subject.settings.renderer = renderer;
        name_settings(subject);
        if (renderer == Renderer::rasterizer) {
          const Frame picture = drawn(subject, subject.settings);
          for (const Counter counter :
               {Counter::triangles_degenerate, Counter::triangles_split, Counter::depth_failures,
                Counter::triangles_clipped_away, Counter::pixels_written})
            EXPECT_GT(picture.counters[counter], 20u) << counter_key(counter) << ", " << subject.words;
        }
        ASSERT_EQ(test::differential_fault(subject, random, paths.seen), "") << subject.words;
      }
  if (test::simd_targets().empty()) GTEST_SKIP() << "this processor has no SIMD target: both sides are the clear path";
  EXPECT_GT(paths.by(Machinery::whole_frame), 12);
}

/// The sample nearest to the pixel's own position says what the pixel shows. The width is no multiple of any lanes.
TEST(Differential, SamplesOfEachPattern) {
  Random random(13);
  Paths paths;
  const auto scene = std::make_shared<const Scene>(load_scene("cgfs/reflections"));
  for (const SamplePattern pattern :
       {SamplePattern::grid, SamplePattern::jitter, SamplePattern::random, SamplePattern::halton, SamplePattern::r2})
    for (const int count : {3, 16})
      for (const bool adaptive : {false, true}) {
        Subject subject{scene, nullptr, {scene->camera, 37, 21}, {}, Channel::ids | Channel::depth, "cgfs/reflections"};
        subject.settings.samples_per_pixel = count;
        subject.settings.sample_pattern = pattern;
        subject.settings.adaptive_sampling = adaptive;
        subject.settings.sample_position = adaptive ? SamplePosition::corner : SamplePosition::centre;
        name_settings(subject);
        ASSERT_EQ(test::differential_fault(subject, random, paths.seen, test::Targets::one), "") << subject.words;
      }
  EXPECT_GT(paths.by(Machinery::sphere_packets), test::simd_targets().empty() ? -1 : 10);
}

/// Products of the materials' reflectivities that are the cutoff itself.
TEST(Differential, SharesEqualToTheCutoff) {
  Random random(9);
  Paths paths;
  const auto scene = std::make_shared<const Scene>(load_scene("cgfs/reflections"));
  for (const double cutoff : {0.01, 0.1, 0.2, 0.5, 1.0}) {
    Subject subject{scene, nullptr, {scene->camera, 130, 70}, {}, Channel::none, "cgfs/reflections"};
    subject.settings.reflection_depth = 64;
    subject.settings.reflection_cutoff = cutoff;
    name_settings(subject);
    ASSERT_EQ(test::differential_fault(subject, random, paths.seen), "") << subject.words;
  }
}

TEST(Differential, EveryWayToDrawAPictureGivesTheSameBits) {
  const unsigned seed = test::test_seed();
  const bool longer = std::getenv("PIXELSCOPE_FUZZ_SECONDS") != nullptr;
  const std::chrono::duration<double> time(test::number_from("PIXELSCOPE_FUZZ_SECONDS", 4));
  Random random(seed);
  Paths paths;
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
      fault = test::differential_fault(*subject, random, paths.seen);
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
