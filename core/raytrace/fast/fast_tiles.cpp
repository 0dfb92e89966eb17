#include "raytrace/fast/fast_tiles.h"

namespace ps {

std::unique_ptr<TileTracer> fast_tiles(const Scene& scene, const TraceInputs<float>& inputs, const SamplingPlan& plan,
                                       Prepared& prepared) {
  switch (inputs.path.machinery) {
  case Machinery::sphere_packets:
    return sphere_tiles(inputs, plan);
  case Machinery::wide_triangles:
    return wide_tiles(scene, inputs, plan, prepared);
  case Machinery::clear:
  case Machinery::fragment_batches:
  case Machinery::whole_frame:
  case Machinery::driver:
    return nullptr;
  }
  return nullptr;
}

}  // namespace ps
