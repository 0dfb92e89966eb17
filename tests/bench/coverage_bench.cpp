// What each coverage strategy costs: small triangles (the teapot) and large ones, on the clear path and one thread,
// with the same picture. Its sample-test efficiency stands in the note.
#include <fmt/core.h>

#include <cstring>

#include "bench/bench.h"
#include "bench/meshes.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "raster/clear/coverage/efficiency.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

struct StrategyPicture {
  Scene scene;
  View view;
  Settings settings;
  std::shared_ptr<Prepared> prepared = std::make_shared<Prepared>();

  Frame draw() const {
    Progress progress;
    return render(scene, view, settings, {}, *prepared, progress);
  }
};

/// Nothing but coverage, depth and one colour for each triangle.
void make_plain(Settings& settings) {
  settings.renderer = Renderer::rasterizer;
  settings.lighting = false;
  settings.near = 0.01;
  settings.threads = 1;
  settings.simd = Simd::off;
}

StrategyPicture small_triangles() {
  const auto mesh = bench_mesh("teapot");
  StrategyPicture picture{mesh_scene(mesh), framed_view(*mesh, 160, 120), {}};
  make_plain(picture.settings);
  return picture;
}

StrategyPicture large_triangles() {
  Scene scene = load_scene("cgfs/depth");
  StrategyPicture picture{scene, {scene.camera, 640, 640}, settings_for(scene)};
  make_plain(picture.settings);
  return picture;
}

Job strategy_job(const StrategyPicture& start, Coverage strategy) {
  const auto ours = std::make_shared<StrategyPicture>(start), yardstick = std::make_shared<StrategyPicture>(start);
  ours->settings.coverage = strategy;
  Job job;
  job.ours = [ours] { ours->draw(); };
  job.yardstick = [yardstick] { yardstick->draw(); };
  job.check = [ours, yardstick, strategy]() -> std::string {
    const Frame a = ours->draw(), b = yardstick->draw();
    const bool same =
        std::memcmp(a.colour.pixels().data(), b.colour.pixels().data(), a.colour.pixels().size_bytes()) == 0;
    // Weights in float may round to the wrong side of an edge.
    return same || strategy == Coverage::barycentric || strategy == Coverage::hoisted
               ? ""
               : "the pictures are not the same bits";
  };
  const Counters counters = ours->draw().counters;
  job.note = fmt::format("{} samples and {} regions tested, {} covered: {:.3g} for each test",
                         counters[Counter::coverage_tests], counters[Counter::coverage_regions],
                         counters[Counter::fragments], raster::sample_test_efficiency(counters).value_or(0));
  return job;
}

}  // namespace

Benches coverage_benches() {
  Benches benches;
  const Option& option = *find_option("coverage");
  for (std::size_t i = 0; i < option.choices.size(); ++i) {
    const auto strategy = static_cast<Coverage>(i);
    benches.push_back({fmt::format("coverage/{}/teapot", option.choices[i].key), "ms", "edge functions",
                       [strategy] { return strategy_job(small_triangles(), strategy); }});
    benches.push_back({fmt::format("coverage/{}/large", option.choices[i].key), "ms", "edge functions",
                       [strategy] { return strategy_job(large_triangles(), strategy); }});
  }
  return benches;
}

}  // namespace ps::bench
