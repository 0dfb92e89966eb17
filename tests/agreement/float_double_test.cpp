// The default float renderer against the double one: same surfaces, same shadows, no surface that shadows or mirrors
// itself by mistake, on every scene that Pixelscope ships with.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "options/scene_settings.h"
#include "raytrace/clear/intersector-inl.h"
#include "raytrace/clear/tracer-inl.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/emulated.h"

namespace ps::float_double_test {
namespace {

constexpr int width = 240, height = 240;

struct Pair {
  TraceInputs<float> narrow;
  TraceInputs<double> wide;
};

Pair inputs_for(const Scene& scene, const Settings& settings, Prepared& prepared) {
  const View view{scene.camera, width, height};
  return {make_trace_inputs<float>(scene, view, settings, prepared),
          make_trace_inputs<double>(scene, view, settings, prepared)};
}

/// For each shadow and reflection ray of a pixel: does it end on the surface that it started on? Rays by depth and, for
/// shadow rays, light (-1 = reflection): the same step of the two stories.
using SelfHits = std::map<std::pair<int, int>, bool>;

/// Collects only that.
class SelfHitRecorder {
 public:
  static constexpr bool counts = false;
  static constexpr bool records = false;
  static constexpr bool one_pixel = false;
  void count(Counter, std::uint64_t = 1) {}
  static constexpr bool wants(int, int) { return false; }
  static constexpr bool collects() { return false; }
  template <class Make>
  void event(Make&& make) {
    using Made = std::remove_cvref_t<decltype(make())>;
    if constexpr (std::is_same_v<Made, HitEvent>) {
      OpenRay& ray = open_.back();
      ray.surface = make().id;
      if (ray.kind == RayKind::reflection) hits_[{ray.depth, -1}] = open_[open_.size() - 2].surface == ray.surface;
    } else if constexpr (std::is_same_v<Made, LightEvent>) {
      const LightEvent light = make();
      hits_[{open_.back().depth, light.light}] = light.blocker == open_.back().surface;
    }
  }
  template <class Make>
  void begin(Make&& make) {
    using Made = std::remove_cvref_t<decltype(make())>;
    static_assert(std::is_same_v<Made, RayEvent>, "rays alone hold other events");
    const RayEvent ray = make();
    open_.push_back({ray.kind, ray.depth, {}});
  }
  void end() { open_.pop_back(); }
  SelfHits take() { return std::move(hits_); }

 private:
  struct OpenRay {
    RayKind kind = RayKind::eye;
    int depth = 0;
    PixelId surface;
  };
  std::vector<OpenRay> open_;
  SelfHits hits_;
};

template <class Real>
SelfHits self_hits(const TraceInputs<Real>& inputs, int x, int y) {
  SelfHitRecorder recorder;
  Tracer<Real, SelfHitRecorder>(inputs, recorder).trace_pixel(x, y);
  return recorder.take();
}

int false_ones(const SelfHits& found, const SelfHits& truth) {
  return static_cast<int>(std::count_if(found.begin(), found.end(), [&](const auto& ray) {
    const auto same = truth.find(ray.first);
    const bool truly = same != truth.end() && same->second;  // absent: the ray left the scene
    return ray.second && !truly;
  }));
}

/// Rays that float says end where they started and double with the robust guard says do not.
struct FalseSelfHits {
  int robust = 0;
  int naive = 0;  ///< the book's way
};

FalseSelfHits false_self_hits(const Scene& scene) {
  Settings settings;
  settings.reflection_depth = 1;  // deeper rays of both precisions start at different points
  Settings book = settings;
  book.self_hit = SelfHit::epsilon;
  book.sphere_test = SphereTest::quadratic;
  Prepared prepared;
  const Pair robust = inputs_for(scene, settings, prepared), naive = inputs_for(scene, book, prepared);
  FalseSelfHits result;
  // Three stories of each pixel take long: every other one is looked at, as on a chessboard.
  for (int y = 0; y < height; y += test::pixel_step()) {
    for (int x = (y / test::pixel_step()) % 2; x < width; x += 2 * test::pixel_step()) {
      const SelfHits truth = self_hits(robust.wide, x, y);
      result.robust += false_ones(self_hits(robust.narrow, x, y), truth);
      result.naive += false_ones(self_hits(naive.narrow, x, y), truth);
    }
  }
  return result;
}

TEST(FloatAndDouble, NoFalseSelfHitOnAnyScene) {
  int naive_total = 0;
  for (const BuiltinScene& entry : builtin_scenes()) {
    const FalseSelfHits hits = false_self_hits(load_scene(entry.name));
    EXPECT_EQ(hits.robust, 0) << entry.name;
    if (hits.naive > 0)
      std::cout << entry.name << ": " << hits.naive << " false self-hits with the book's epsilon in float\n";
    naive_total += hits.naive;
  }
  EXPECT_GT(naive_total, 50) << "the test must see the acne of the naive settings";
}

/// Share of the pixels showing the book's ground, alone in the scene, whose mirror ray meets the ground again.
double ground_mirrors_itself(const Settings& settings) {
  Scene scene = load_scene("cgfs/reflections");
  scene.geometry.edit(
      [](Geometry& geometry) { geometry.objects.erase(geometry.objects.begin(), geometry.objects.end() - 1); });
  Prepared prepared;
  const TraceInputs<float> inputs = make_trace_inputs<float>(scene, View{scene.camera, 600, 600}, settings, prepared);
  int ground = 0, again = 0;
  CountingRecorder recorder;
  const Tracer<float, CountingRecorder> tracer(inputs, recorder);
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < 600; ++x) {
      const std::uint64_t shaded = recorder.counters[Counter::shading_calls];
      tracer.trace_pixel(x, y);
      const std::uint64_t surfaces = recorder.counters[Counter::shading_calls] - shaded;
      ground += surfaces > 0 ? 1 : 0;
      again += surfaces > 1 ? 1 : 0;
    }
  }
  std::cout << again << " of " << ground << " ground pixels mirror the ground\n";
  return static_cast<double>(again) / ground;
}

TEST(FloatAndDouble, TheGroundDoesNotMirrorItself) {
  Settings settings;
  settings.reflection_depth = 1;
  EXPECT_EQ(ground_mirrors_itself(settings), 0);
  settings.sphere_test = SphereTest::quadratic;
  settings.self_hit = SelfHit::epsilon;
  settings.sample_position = SamplePosition::corner;
  EXPECT_NEAR(ground_mirrors_itself(settings), 9827.0 / 172699, 1e-4) << "measured by an independent program";
}

struct Seen {
  PixelId id;
  std::uint32_t shadow = 0;
  bool operator==(const Seen&) const = default;
};

template <class Real>
Seen seen_at(const TraceInputs<Real>& inputs, int x, int y) {
  Silent silent;
  const TracedPixel<Real> pixel = Tracer<Real, Silent>(inputs, silent).trace_pixel(x, y);
  if (!pixel.hit.found()) return {};
  return {inputs.geometry->primitives[pixel.hit.primitive].id, pixel.shadow_mask};
}

/// Would double see the same if the sample moved by less than float can tell?
bool within_rounding(const TraceInputs<double>& inputs, const Seen& seen, int x, int y) {
  constexpr double nudge = 2e-4;  // pixels
  TraceInputs<double> moved = inputs;
  for (const Vec2d& step : {Vec2d(nudge, 0), Vec2d(-nudge, 0), Vec2d(0, nudge), Vec2d(0, -nudge)}) {
    moved.viewport.sample = inputs.viewport.sample + step;
    if (seen_at(moved, x, y) == seen) return true;
  }
  return false;
}

TEST(FloatAndDouble, SameSurfacesAndShadowsOnEveryScene) {
  for (const BuiltinScene& entry : builtin_scenes()) {
    const Scene scene = load_scene(entry.name);
    if (!settings_for(scene).camera_relative) continue;  // made to show how float fails far from the origin
    if (entry.name == "cgpp/one-dimension") continue;    // its rows touch without sharing vertices: cracks are allowed
    Settings settings;
    settings.reflection_depth = 0;
    Prepared prepared;
    const Pair inputs = inputs_for(scene, settings, prepared);
    int differing = 0;
    for (int y = 0; y < height; y += test::pixel_step()) {
      for (int x = 0; x < width; x += test::pixel_step()) {
        const Seen narrow = seen_at(inputs.narrow, x, y);
        if (narrow == seen_at(inputs.wide, x, y)) continue;
        ++differing;
        EXPECT_TRUE(within_rounding(inputs.wide, narrow, x, y)) << entry.name << " at " << x << ", " << y;
      }
    }
    if (scene_traits(scene).spheres) {
      EXPECT_EQ(differing, 0) << entry.name;
    }
    // Samples that lie exactly on an edge of a triangle may fall either way.
    EXPECT_LE(differing, width * height / 500) << entry.name;
  }
}

}  // namespace
}  // namespace ps::float_double_test
