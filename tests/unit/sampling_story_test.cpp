// One click on a pixel of several samples: the story must give the picture's number, and show it in samples.
#include <gtest/gtest.h>

#include "frame/display_frame.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/trials.h"

namespace ps::sampling_story_test {
namespace {

constexpr int width = 75, height = 75;

Frame sampled(const Scene& scene, const Settings& settings) {
  return render(scene, View{scene.camera, width, height}, settings, request_for(Channel::samples));
}

PixelStory inspected(const Scene& scene, const Settings& settings, Vec2i pixel) {
  return inspect(scene, View{scene.camera, width, height}, settings, pixel);
}

Vec3d top_level_sum(const PixelStory& story) {
  Vec3d sum{0, 0, 0};
  for (const LedgerLine& line : story.ledger)
    if (line.level == 0) sum += line.value;
  return sum;
}

std::size_t lines_of_level(const PixelStory& story, int level) {
  std::size_t count = 0;
  for (const LedgerLine& line : story.ledger) count += line.level == level ? 1 : 0;
  return count;
}

std::vector<SampleEvent> samples_of(const PixelStory& story) {
  std::vector<SampleEvent> samples;
  for (const int index : events_of_ray<SampleEvent>(story.events, -1))
    samples.push_back(event_as<SampleEvent>(story.events, index));
  return samples;
}

TEST(SamplingStory, LedgerOfSamplesSumsToTheFramebuffer) {
  const Scene scene = load_scene("cgfs/reflections");
  for (const Precision precision : {Precision::float32, Precision::float64})
    for (const int count : {1, 3, 9, 64}) {
      Settings settings;
      settings.precision = precision;
      settings.samples_per_pixel = count;
      settings.sample_pattern = SamplePattern::jitter;
      const Frame frame = sampled(scene, settings);
      for (const Vec2i pixel : {Vec2i{37, 52}, Vec2i{25, 30}, Vec2i{0, 0}, Vec2i{58, 41}}) {
        const PixelStory story = inspected(scene, settings, pixel);
        EXPECT_EQ(story.linear, linear_at(frame, pixel));
        const Vec3d sum = top_level_sum(story);
        EXPECT_EQ(sum, story.linear);
        const auto samples = samples_of(story);
        ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
        Vec3d mean{0, 0, 0};
        double weight = 0;
        for (const SampleEvent& sample : samples) {
          mean += sample.weight * sample.colour;
          weight += sample.weight;
          EXPECT_TRUE(sample.position.x >= 0 && sample.position.x < 1 && sample.position.y >= 0 &&
                      sample.position.y < 1);
        }
        EXPECT_NEAR(weight, 1, 1e-12);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], story.linear[k], 1e-6);
        if (pixel == Vec2i{37, 52} && count == 3) {
          EXPECT_GT(lines_of_level(story, 1), 3u);  // each sample's own story
        }
      }
    }
}

TEST(SamplingStory, AdaptiveShowsWhyItSubdivided) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings;
  settings.samples_per_pixel = 9;
  settings.adaptive_sampling = true;
  settings.adaptive_threshold = 0.05;
  const Frame frame = sampled(scene, settings);
  int subdivided = 0, left = 0;
  for (int y = 20; y < 60; y += 3)
    for (int x = 10; x < 70; x += 5) {
      const PixelStory story = inspected(scene, settings, {x, y});
      const auto comparisons = events_of_ray<CompareEvent>(story.events, -1);
      ASSERT_EQ(comparisons.size(), 4u);
      bool any = false;
      for (const int index : comparisons) any = any || event_as<CompareEvent>(story.events, index).subdivides;
      ASSERT_EQ(any, frame.samples.at(x, y) == 9) << x << " " << y;
      ASSERT_EQ(samples_of(story).size(), any ? 9u : 0u);
      ASSERT_EQ(story.linear, linear_at(frame, {x, y}));
      (any ? subdivided : left) += 1;
    }
  EXPECT_GT(subdivided, 10);
  EXPECT_GT(left, 10);
}

TEST(SamplingStory, SubsamplingReportsReuse) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings;
  settings.subsampling = 4;
  const Frame frame = sampled(scene, settings);
  int met = 0, searched = 0;
  for (int y = 20; y < 60; y += 3)
    for (int x = 10; x < 70; x += 5) {
      const PixelStory story = inspected(scene, settings, {x, y});
      ASSERT_EQ(story.linear, linear_at(frame, {x, y}));
      const int eye = eye_ray(story.events);
      const auto reuse = events_of_ray<ReuseEvent>(story.events, eye);
      const std::size_t tests = events_of_ray<SphereTestEvent>(story.events, eye).size();
      if (!reuse.empty() && event_as<ReuseEvent>(story.events, reuse[0]).met) {
        ++met;
        ASSERT_LE(tests, 1u);  // the one object, or nothing at all
      } else {
        ++searched;
        ASSERT_GE(tests, 4u);
      }
    }
  EXPECT_GT(met, 50);
  EXPECT_GT(searched, 5);
}

// With the shadow cache a blocker found before is tested first: the inspector must start from the tile's beginning to
// name the one that the picture found.
TEST(SamplingStory, ShadowCacheIsReplayed) {
  const Scene scene = load_scene("cgfs/fence");
  Settings settings;
  settings.shadow_cache = true;
  settings.simd = Simd::off;
  settings.accelerator = Accelerator::none;
  std::uint64_t tests = 0;
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, 20, 20};
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const PixelStory story = inspect(scene, view, settings, {x, y}, prepared, progress);
      tests += story.counters[Counter::sphere_tests] + story.counters[Counter::solid_tests];
    }
  const Frame frame = render(scene, view, settings, {}, prepared, progress);
  // One tile holds the whole picture, so the pixels' own work is that of the picture.
  EXPECT_EQ(tests, frame.counters[Counter::sphere_tests] + frame.counters[Counter::solid_tests]);
}

// The second pass of an adaptive picture fills the cache anew, by the pixels that it chose alone.
TEST(SamplingStory, ShadowCacheIsReplayedForChosenPixels) {
  const Scene scene = load_scene("cgfs/fence");
  Settings settings;
  settings.shadow_cache = true;
  settings.samples_per_pixel = 4;
  settings.adaptive_sampling = true;
  settings.simd = Simd::off;
  settings.accelerator = Accelerator::none;
  Prepared prepared;
  Progress progress;
  const View view{scene.camera, 20, 20};
  const Frame frame = render(scene, view, settings, request_for(Channel::tests | Channel::samples), prepared, progress);
  int subdivided = 0;
  constexpr int columns = static_cast<int>(test::list_step);  // each story draws all pixels before its own again
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; x += columns) {
      const PixelStory story = inspect(scene, view, settings, {x, y}, prepared, progress);
      EXPECT_EQ(story.counters[Counter::sphere_tests] + story.counters[Counter::solid_tests] +
                    story.counters[Counter::triangle_tests],
                frame.tests.at(x, y))
          << x << ", " << y;
      subdivided += frame.samples.at(x, y) > 1 ? 1 : 0;
    }
  EXPECT_GT(subdivided, 50 / columns);
  EXPECT_LT(subdivided, 350 / columns);
}

}  // namespace
}  // namespace ps::sampling_story_test
