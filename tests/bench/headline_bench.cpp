// The scene of "Speed-up raycasting with Octrees", one thread throughout: about 34 thousand triangles, 640x480.

#include <cstring>
#include <memory>

#include "bench/bench.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

struct Headline {
  Scene scene = load_scene("octree/headline");
  Prepared prepared;  // trees are built once, outside the times

  Frame render(Accelerator accelerator, int width, int height) {
    Settings settings = settings_for(scene);
    settings.threads = 1;
    settings.accelerator = accelerator;
    Progress progress;
    return render_traced(scene, View{scene.camera, width, height}, settings, {}, prepared, progress);
  }
};

bool same_picture(const Frame& a, const Frame& b) {
  return std::memcmp(a.colour.pixels().data(), b.colour.pixels().data(), a.colour.pixels().size_bytes()) == 0;
}

Job headline_job(Accelerator accelerator) {
  const auto headline = std::make_shared<Headline>();
  Job job;
  job.ours = [headline, accelerator] { headline->render(accelerator, 640, 480); };
  job.check = [headline, accelerator]() -> std::string {  // at a tenth of the size: testing everything takes long
    const Frame ours = headline->render(accelerator, 64, 48), all = headline->render(Accelerator::none, 64, 48);
    return same_picture(ours, all) ? "" : "the picture is not that of testing everything";
  };
  job.note = "640x480, one thread";
  return job;
}

}  // namespace

Benches headline_benches() {
  return {{"headline/octree", "ms", "", [] { return headline_job(Accelerator::octree); }},
          {"headline/bvh", "ms", "", [] { return headline_job(Accelerator::bvh); }},
          {"headline/none", "ms", "", [] { return headline_job(Accelerator::none); }}};
}

}  // namespace ps::bench
