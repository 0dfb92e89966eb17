#include "base/counters.h"

namespace ps {
namespace {

struct CounterName {
  std::string_view key;
  std::string_view label;
};

constexpr std::array<CounterName, counter_count> names{{
    {"eye-rays", "eye rays"},
    {"shadow-rays", "shadow rays"},
    {"reflection-rays", "reflection rays"},
    {"refraction-rays", "refraction rays"},
    {"sphere-tests", "ray-sphere tests"},
    {"triangle-tests", "ray-triangle tests"},
    {"solid-tests", "ray-solid tests"},
    {"node-visits", "accelerator nodes visited"},
    {"edge-rays", "hits at an edge decided by Embree"},
    {"shading-calls", "shading calls"},
    {"light-samples", "lights evaluated"},
    {"texel-reads", "texels read"},
    {"triangles-in", "triangles in"},
    {"objects-culled", "objects outside the view"},
    {"triangles-backfacing", "back faces culled"},
    {"triangles-clipped-away", "triangles clipped away"},
    {"triangles-split", "triangles split by a plane"},
    {"triangles-degenerate", "zero-area triangles"},
    {"triangles-drawn", "triangles drawn"},
    {"coverage-tests", "coverage tests"},
    {"coverage-regions", "rows, cells or pieces tested"},
    {"fragments", "fragments"},
    {"subsamples", "sub-samples covered"},
    {"depth-tests", "depth tests"},
    {"depth-failures", "fragments hidden"},
    {"attributes-interpolated", "scalars interpolated"},
    {"pixels-written", "pixels written"},
    {"lines-drawn", "lines drawn"},
    {"pixels-subdivided", "pixels subdivided"},
    {"searches-saved", "searches saved by reuse"},
    {"nan-pixels", "NaN pixels"},
    {"shadow-map-taps", "shadow map taps"},
    {"silhouette-edges", "silhouette edges"},
    {"stencil-tests", "shadow volume samples"},
    {"stencil-updates", "stencil updates"},
    {"environment-reads", "cube maps read"},
    {"octree-entries", "primitives listed in octree cells"},
}};

}  // namespace

std::string_view counter_key(Counter counter) { return names[static_cast<std::size_t>(counter)].key; }
std::string_view counter_label(Counter counter) { return names[static_cast<std::size_t>(counter)].label; }

std::optional<std::uint64_t> counted_sum(const Counters& counters, std::initializer_list<Counter> summands) {
  std::optional<std::uint64_t> sum;
  for (const Counter summand : summands)
    if (const auto count = counters.get(summand)) sum = sum.value_or(0) + *count;
  return sum;
}

}  // namespace ps
