// The book's reflection scene traced in packets on every SIMD target, beside the clear path.

#include <cstring>
#include <memory>

#include "bench/bench.h"
#include "raytrace/renderer.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::bench {
namespace {

constexpr int width = 1280, height = 720;

Frame picture(const Scene& scene, Simd simd) {
  Settings settings;
  settings.threads = 2;
  settings.simd = simd;
  Prepared prepared;
  Progress progress;
  return render_traced(scene, View{scene.camera, width, height}, settings, {}, prepared, progress);
}

/// The whole picture with three bounces on two threads, beside the clear path.
Job picture_job(Simd simd) {
  const auto scene = std::make_shared<Scene>(load_scene("cgfs/reflections"));
  Job job;
  job.ours = [scene, simd] { picture(*scene, simd); };
  job.yardstick = [scene] { picture(*scene, Simd::off); };
  job.check = [scene, simd]() -> std::string {
    const Frame fast = picture(*scene, simd), clear = picture(*scene, Simd::off);
    const auto bytes = clear.colour.pixels().size_bytes();
    const bool same = std::memcmp(fast.colour.pixels().data(), clear.colour.pixels().data(), bytes) == 0;
    return same ? "" : "the pictures are not the same bits";
  };
  job.note = "1280x720, 3 bounces, two threads";
  return job;
}

}  // namespace

Benches packets_benches() {
  return {
      {"packets/reflections/avx512", "ms", "clear path", [] { return picture_job(Simd::avx512); }},
      {"packets/reflections/avx2", "ms", "clear path", [] { return picture_job(Simd::avx2); }},
      {"packets/reflections/sse4", "ms", "clear path", [] { return picture_job(Simd::sse4); }},
  };
}

}  // namespace ps::bench
