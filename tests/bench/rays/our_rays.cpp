#include "bench/rays/our_rays.h"

#include "bench/meshes.h"
#include "raytrace/fast/fast_intersector.h"

namespace ps::bench {

struct OurRays::Content {
  Scene scene;
  std::shared_ptr<Prepared> prepared;
  TraceInputs<float> inputs;
  std::optional<WideInputs> wide;

  /// Calls use(search) with the search that draws pictures of this scene.
  template <class Use>
  void search(Use&& use) const {
    CountingRecorder recorder;
    if (wide)
      use(FastIntersector(inputs, *wide, recorder));
    else
      use(Intersector<float, CountingRecorder>(inputs, recorder));
  }
};

OurRays::OurRays(const Scene& scene, const Settings& settings, std::shared_ptr<Prepared> prepared)
    : content_(std::make_unique<Content>()) {
  content_->scene = scene;
  content_->prepared = std::move(prepared);
  content_->inputs = make_trace_inputs<float>(scene, View{}, settings, *content_->prepared);
  content_->wide = wide_inputs(scene, content_->inputs, *content_->prepared);
}
OurRays::~OurRays() = default;
OurRays::OurRays(OurRays&&) noexcept = default;

void OurRays::nearest(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  content_->search([&](const RaySearch<float>& search) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit<float> hit = search.nearest({rays[i].origin, rays[i].direction, 0, rays[i].t_max, no_primitive});
      hits[i] = {hit.found() ? hit.primitive : no_hit, hit.t};
    }
  });
}

void OurRays::nearest_together(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  content_->search([&](const RaySearch<float>& search) {
    std::array<Ray<float>, rays_at_once> some;
    std::array<Hit<float>, rays_at_once> found;
    for (std::size_t first = 0; first < rays.size(); first += rays_at_once) {
      const std::size_t count = std::min(rays_at_once, rays.size() - first);
      for (std::size_t i = 0; i < count; ++i) {
        some[i].origin = rays[first + i].origin;
        some[i].direction = rays[first + i].direction;
        some[i].t_max = rays[first + i].t_max;
      }
      search.nearest_of_each(std::span<const Ray<float>>(some.data(), count), std::span(found.data(), count));
      for (std::size_t i = 0; i < count; ++i)
        hits[first + i] = {found[i].found() ? found[i].primitive : no_hit, found[i].t};
    }
  });
}

void OurRays::any(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  content_->search([&](const RaySearch<float>& search) {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Hit<float> hit = search.any({rays[i].origin, rays[i].direction, 0, rays[i].t_max, no_primitive});
      hits[i] = {hit.found() ? hit.primitive : no_hit, hit.t};
    }
  });
}

void OurRays::rebuild() {
  Prepared empty;
  content_->wide.reset();
  content_->wide = wide_inputs(content_->scene, content_->inputs, empty);
}

double OurRays::bytes_per_triangle() const {
  const TraceInputs<float>& inputs = content_->inputs;
  const TracedGeometry<float>& geometry = *inputs.geometry;
  std::size_t bytes = geometry.primitives.size() * sizeof(Primitive) +
                      geometry.triangles.size() * sizeof(TracedTriangle<float>) +
                      geometry.attributes.size() * sizeof(TriangleAttributes<float>);
  if (content_->wide)
    bytes += content_->wide->wide->triangles.nodes.size() * sizeof(WideNode) +
             content_->wide->wide->triangles.blocks.size() * sizeof(TriangleBlock);
  return static_cast<double>(bytes) / static_cast<double>(geometry.triangles.size());
}

}  // namespace ps::bench
