// The default float renderer against the double one: same surfaces, same shadows, no surface that shadows or mirrors
// itself by mistake, on every scene that Pixelscope ships with.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "options/scene_settings.h"
#include "raytrace/tracer.h"
#include "render/render.h"
#include "scene/load.h"

namespace {

using namespace ps;

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

/// Rays by depth and, for shadow rays, light: the same step of the two stories.
using SelfHits = std::map<std::pair<int, int>, bool>;

/// For each shadow and reflection ray of the pixel: does it end on the surface that it started on?
SelfHits self_hits(const std::vector<Event>& events) {
  SelfHits result;
  std::map<int, PixelId> surfaces;  // of rays, by event
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& event = events[i];
    if (const auto* hit = std::get_if<HitEvent>(&event.data)) {
      surfaces[event.parent] = hit->id;
      const auto& ray = std::get<RayEvent>(events[static_cast<std::size_t>(event.parent)].data);
      const int from = events[static_cast<std::size_t>(event.parent)].parent;
      if (ray.kind == RayKind::reflection) result[{ray.depth, -1}] = surfaces.at(from) == hit->id;
    }
    if (const auto* light = std::get_if<LightEvent>(&event.data)) {
      const auto& ray = std::get<RayEvent>(events[static_cast<std::size_t>(event.parent)].data);
      result[{ray.depth, light->light}] = light->blocker == surfaces.at(event.parent);
    }
  }
  return result;
}

template <class Real>
std::vector<Event> events_of(const TraceInputs<Real>& inputs, int x, int y) {
  PixelRecorder recorder({x, y});
  Tracer<Real, PixelRecorder>(inputs, recorder).trace_pixel(x, y);
  return recorder.take();
}

/// Rays of the whole picture that float says end where they started and double says do not.
int false_self_hits(const Pair& inputs) {
  int result = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const SelfHits found = self_hits(events_of(inputs.narrow, x, y));
      const SelfHits truth = self_hits(events_of(inputs.wide, x, y));
      for (const auto& [ray, self] : found) {
        const auto same = truth.find(ray);
        const bool truly = same != truth.end() && same->second;  // absent: the ray left the scene
        if (self && !truly) ++result;
      }
    }
  }
  return result;
}

TEST(FloatAndDouble, NoFalseSelfHitOnAnyScene) {
  int naive_total = 0;
  for (const BuiltinScene& entry : builtin_scenes()) {
    const Scene scene = load_scene(entry.name);
    Settings settings;
    settings.reflection_depth = 1;  // deeper rays of both precisions start at different points
    Prepared prepared;
    EXPECT_EQ(false_self_hits(inputs_for(scene, settings, prepared)), 0) << entry.name;
    // The book's way, in float against in double, with the robust guard as the truth.
    Settings book = settings;
    book.self_hit = SelfHit::epsilon;
    book.sphere_test = SphereTest::quadratic;
    Pair naive = inputs_for(scene, book, prepared);
    naive.wide = inputs_for(scene, settings, prepared).wide;
    const int naive_hits = false_self_hits(naive);
    std::cout << entry.name << ": " << naive_hits << " false self-hits with the book's epsilon in float\n";
    naive_total += naive_hits;
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
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
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
