#pragma once
#include <memory>
#include <span>

#include "bench/rays/ray_set.h"
#include "frame/prepared.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::bench {

/// Our ray queries on one mesh, without a renderer around them: float, single rays, the calling thread only.
class OurRays {
 public:
  /// The scene's triangles must all have area, so that a primitive's number is its triangle's. What is built for it
  /// stays in `prepared`, to be shared between settings.
  OurRays(const Scene& scene, const Settings& settings, std::shared_ptr<Prepared> prepared);
  ~OurRays();
  OurRays(OurRays&&) noexcept;

  void nearest(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;
  /// nearest(), neighbours together.
  void nearest_together(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;
  void any(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;

  /// Builds the accelerator anew, as a renderer does when the geometry changed.
  void rebuild();
  double bytes_per_triangle() const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace ps::bench
