// What each optimisation of the ray tracer gains by itself: the same picture with it and without it (CGFS ch. 5).

#include <fmt/core.h>

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "image/metrics.h"
#include "options/scene_settings.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#include "study/same_machinery.h"

namespace ps::bench {
namespace {

struct GainPicture {
  Scene scene;
  View view;
  Settings settings;
  std::shared_ptr<Prepared> prepared = std::make_shared<Prepared>();  ///< trees are built once, outside the times

  Frame render() const {
    Progress progress;
    return render_traced(scene, view, settings, {}, *prepared, progress);
  }
};

using Change = std::function<void(Settings&)>;

/// Where the clear path works on one thread, so that each gain stands alone.
Settings plain_settings() {
  Settings settings;
  settings.threads = 1;
  settings.simd = Simd::off;
  return settings;
}

GainPicture book_picture() {
  const Scene scene = load_scene("cgfs/reflections");
  return {scene, View{scene.camera, 320, 320}, plain_settings()};
}

GainPicture mesh_picture(int width, int height) {
  const auto mesh = bench_mesh("teapot");
  return {mesh_scene(mesh), framed_view(*mesh, width, height), plain_settings()};
}

/// The share of pixels that differ. None may, unless the gain is bought with a guess.
double share_of_differing(const Frame& a, const Frame& b) {
  return static_cast<double>(compare_channels(a.colour, b.colour).differing) /
         static_cast<double>(a.colour.pixels().size());
}

Job gain_job(const GainPicture& start, const Change& with, const Change& without, double allowed_share) {
  const auto ours = std::make_shared<GainPicture>(start), yardstick = std::make_shared<GainPicture>(start);
  with(ours->settings);
  without(yardstick->settings);
  const std::array both{ours->settings, yardstick->settings};
  const std::array<std::string, 2> labels{"with it", "without it"};
  const TimedSettings timed = on_same_machinery(both, labels, scene_traits(start.scene));
  ours->settings = timed.settings[0];
  yardstick->settings = timed.settings[1];
  Job job;
  job.ours = [ours] { ours->render(); };
  job.yardstick = [yardstick] { yardstick->render(); };
  job.check = [ours, yardstick, allowed_share]() -> std::string {
    const double share = share_of_differing(ours->render(), yardstick->render());
    if (share <= allowed_share) return "";
    return fmt::format("{:.2f} % of the pixels differ", 100 * share);
  };
  job.note = fmt::format("{} x {}, {}, {}", start.view.width, start.view.height, start.scene.name, timed.reason);
  return job;
}

Bench gain(const std::string& name, const std::string& without_name, std::function<GainPicture()> picture, Change with,
           Change without, double allowed_share = 0) {
  return {"gains/" + name, "ms", without_name,
          [picture = std::move(picture), with = std::move(with), without = std::move(without), allowed_share] {
            return gain_job(picture(), with, without, allowed_share);
          }};
}

Change accelerator(Accelerator choice) {
  return [choice](Settings& s) { s.accelerator = choice; };
}

}  // namespace

Benches gains_benches() {
  const auto nothing = [](Settings&) {};
  const auto mesh = [] { return mesh_picture(256, 192); };
  const auto small_mesh = [] { return mesh_picture(48, 36); };  // without an accelerator this takes long
  Benches benches{
      gain(
          "threads/book", "one thread", book_picture, [](Settings& s) { s.threads = 2; }, nothing),
      gain(
          "simd/book", "clear path", book_picture, [](Settings& s) { s.simd = Simd::automatic; }, nothing),
      gain("any-hit/book", "nearest", book_picture, nothing, [](Settings& s) { s.shadow_any_hit = false; }),
      gain(
          "shadow-cache/book", "no cache", book_picture, [](Settings& s) { s.shadow_cache = true; }, nothing),
      gain(
          "useful-shadow-rays/book", "all", book_picture, [](Settings& s) { s.shadow_rays = ShadowRays::useful; },
          nothing),
      gain("cache-constants/book", "no cache", book_picture, nothing, [](Settings& s) { s.cache_constants = false; }),
      gain(
          "threads/teapot", "one thread", mesh, [](Settings& s) { s.threads = 2; }, nothing),
      gain(
          "simd/teapot", "clear path", mesh, [](Settings& s) { s.simd = Simd::automatic; }, nothing),
      gain("any-hit/teapot", "nearest", mesh, nothing, [](Settings& s) { s.shadow_any_hit = false; }),
      gain(
          "shadow-cache/teapot", "no cache", mesh, [](Settings& s) { s.shadow_cache = true; }, nothing),
      gain("cache-constants/teapot", "no cache", mesh, nothing, [](Settings& s) { s.cache_constants = false; }),
  };
  // These buy time with a guess: slivers thinner than the step, detail between the first rays.
  for (const int step : {2, 8})
    benches.push_back(gain(
        fmt::format("subsampling-{}/book", step), "every pixel searched", book_picture,
        [step](Settings& s) { s.subsampling = step; }, nothing, 0.01));
  for (const int step : {2, 8})  // beside the fast path
    benches.push_back(gain(
        fmt::format("subsampling-{}/book-simd", step), "every pixel searched",
        [] {
          GainPicture picture = book_picture();
          picture.settings.simd = Simd::automatic;
          return picture;
        },
        [step](Settings& s) { s.subsampling = step; }, nothing, 0.01));
  for (const auto accelerator : {Accelerator::none, Accelerator::bvh})
    benches.push_back(gain(
        fmt::format("subsampling-8/headline-{}", accelerator == Accelerator::none ? "none" : "bvh"),
        "every pixel searched",
        [accelerator] {
          const Scene scene = load_scene("octree/headline");
          GainPicture picture{scene, View{scene.camera, 160, 120}, settings_for(scene)};
          picture.settings.threads = 1;
          picture.settings.accelerator = accelerator;
          return picture;
        },
        [](Settings& s) { s.subsampling = 8; }, nothing, 0.02));
  benches.push_back(gain(
      "adaptive-16/book", "16 samples everywhere", book_picture,
      [](Settings& s) {
        s.samples_per_pixel = 16;
        s.adaptive_sampling = true;
      },
      [](Settings& s) { s.samples_per_pixel = 16; }, 1));
  struct Choice {
    const char* name;
    Accelerator accelerator;
  };
  for (const auto& [name, choice] :
       {Choice{"box", Accelerator::box}, Choice{"octree", Accelerator::octree},
        Choice{"bounding-spheres", Accelerator::bounding_spheres}, Choice{"bvh", Accelerator::bvh}})
    benches.push_back(gain(fmt::format("{}/teapot", name), "no accelerator", small_mesh, accelerator(choice),
                           accelerator(Accelerator::none)));
  return benches;
}

}  // namespace ps::bench
