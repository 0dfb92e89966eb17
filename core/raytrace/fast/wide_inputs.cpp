#include "raytrace/fast/wide_inputs.h"

#include "base/check.h"
#include "options/triangle_tests.h"

namespace ps {

std::optional<WideInputs> wide_inputs(const Scene& scene, const TraceInputs<float>& inputs, Prepared& prepared) {
  const TracedGeometry<float>& geometry = *inputs.geometry;
  const Settings& settings = inputs.settings;
  // Triangles without area are left out: there may be none to search.
  const bool none = geometry.triangles.empty() && !shares_meshes(geometry);
  if (inputs.path.machinery != Machinery::wide_triangles || none) return {};
  const std::optional<SimdTriangleTest> test = row_of(settings.triangle_test).simd;
  PS_ASSERT(test.has_value(), "traced_fast_path() lets no other test through");
  WideInputs wide;
  wide.only_triangles = only_float_triangles(geometry);
  wide.searches = wide_searches(settings.simd, *test);
  wide.instance_searches = instance_searches(settings.simd, *test);
  wide.packets = packet_searches(settings.simd, *test);
  if (!wide.searches.nearest) return {};
  if (std::holds_alternative<NoAccelerator>(inputs.accelerator))
    wide.list = list_geometry(scene, geometry, prepared);
  else if (const auto* octree = accelerator_as<Octree<float>>(inputs.accelerator))
    wide.wide = wide_octree_geometry(scene, geometry, *octree, settings, prepared);
  else if (const auto* trees = accelerator_as<TwoLevel<float>>(inputs.accelerator))
    wide.instances = wide_instances(scene, geometry, *trees, prepared);
  else
    wide.wide = wide_geometry(scene, geometry, prepared);
  if (wide.wide) wide.seen = {wide.wide->triangles.centre, wide.wide->reach};
  if (wide.instances) wide.seen = wide.instances->seen;
  return wide;
}

}  // namespace ps
