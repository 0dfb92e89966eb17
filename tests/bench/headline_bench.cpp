// The scene of "Speed-up raycasting with Octrees", one thread throughout: about 34 thousand triangles, 640x480. Beside
// our whole pictures stand the bare eye rays of the same triangles in Embree, without shading.

#include <cstring>
#include <memory>

#include "bench/bench.h"
#include "options/scene_settings.h"
#include "raytrace/base/geometry.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"
#ifdef PIXELSCOPE_EMBREE
#include "bench/embree/embree_scene.h"
#endif

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

#ifdef PIXELSCOPE_EMBREE
/// All triangles of the scene where they stand.
Mesh triangles_of(const Scene& scene) {
  Prepared prepared;
  const auto geometry = traced_geometry<float>(scene, Settings{}, prepared);
  Mesh mesh;
  for (const TracedTriangle<float>& triangle : geometry->triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3f& corner : {triangle.a, triangle.b, triangle.c}) mesh.positions.emplace_back(corner);
    MeshTriangle& corners = mesh.triangles.emplace_back();
    corners.position = {first, first + 1, first + 2};
  }
  return mesh;
}

std::function<void()> eye_rays_in_embree(const Scene& scene, int width, int height) {
  struct EyeRays {
    EmbreeScene embree;
    std::vector<BenchRay> rays;
    std::vector<BenchHit> hits;
  };
  const std::shared_ptr<EyeRays> eye(new EyeRays{
      EmbreeScene(triangles_of(scene), EmbreeMode::fast, 1), primary_rays(View{scene.camera, width, height}), {}});
  eye->hits.resize(eye->rays.size());
  return [eye] { eye->embree.nearest(eye->rays, eye->hits); };
}
#endif

Job headline_job(Accelerator accelerator) {
  const auto headline = std::make_shared<Headline>();
  Job job;
  job.ours = [headline, accelerator] { headline->render(accelerator, 640, 480); };
#ifdef PIXELSCOPE_EMBREE
  job.yardstick = eye_rays_in_embree(headline->scene, 640, 480);
#endif
  job.check = [headline, accelerator]() -> std::string {  // at a tenth of the size: testing everything takes long
    const Frame ours = headline->render(accelerator, 64, 48), all = headline->render(Accelerator::none, 64, 48);
    return same_picture(ours, all) ? "" : "the picture is not that of testing everything";
  };
  job.note = "640x480, one thread";
  return job;
}

}  // namespace

Benches headline_benches() {
#ifdef PIXELSCOPE_EMBREE
  constexpr const char* yardstick = "Embree's rays";
#else
  constexpr const char* yardstick = "";
#endif
  return {{"headline/octree", "ms", yardstick, [] { return headline_job(Accelerator::octree); }},
          {"headline/bvh", "ms", yardstick, [] { return headline_job(Accelerator::bvh); }},
          {"headline/none", "ms", yardstick, [] { return headline_job(Accelerator::none); }}};
}

}  // namespace ps::bench
