#include "raytrace/fast/fast_tiles.h"
#include "raytrace/fast/packet.h"
#include "raytrace/fast/packet_many.h"

namespace ps {
namespace {

class SphereTiles final : public TileTracer {
 public:
  SphereTiles(const TraceInputs<float>& inputs, const SamplingPlan& plan)
      : path_(inputs.path), plan_(plan), scene_(packet_scene(inputs)),
        functions_(packet_functions(inputs.settings.simd)) {}

  FastPath path() const override { return path_; }

  void trace(const TileRect& tile, const TileRect& part, Frame& frame, Counters& counters) const override {
    if (plan_.mode != SamplingMode::many) return functions_.tile(scene_, tile, part, frame, counters);
    std::vector<Vec2i> pixels;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x) pixels.push_back({x, y});
    trace_many_packets(scene_, functions_.samples, plan_, pixels, frame, counters);
    counters[Counter::pixels_written] += pixels.size();
  }

  void subdivide(const TileRect&, std::span<const Vec2i> pixels, Frame& frame, Counters& counters) const override {
    trace_many_packets(scene_, functions_.samples, with_all_samples(plan_), pixels, frame, counters);
  }

 private:
  FastPath path_;
  SamplingPlan plan_;
  PacketScene scene_;
  PacketFunctions functions_;
};

}  // namespace

std::unique_ptr<TileTracer> sphere_tiles(const TraceInputs<float>& inputs, const SamplingPlan& plan) {
  if (!suits_packets(inputs)) return nullptr;
  return std::make_unique<SphereTiles>(inputs, plan);
}

}  // namespace ps
