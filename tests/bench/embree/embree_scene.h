#pragma once
#include <span>

#include "bench/rays/ray_set.h"
#include "raytrace/base/embree_version.h"

namespace ps::bench {

/// Embree's default single-ray queries, or those with its robust flag (no ray slips between two triangles).
enum class EmbreeMode { fast, robust };

/// One mesh in Embree, default build quality. Built with `threads` threads; queries run on the calling thread.
class EmbreeScene {
 public:
  EmbreeScene(const Mesh& mesh, EmbreeMode mode, int threads);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  void nearest(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;
  void any(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;
  /// nearest() in packets of 16 neighbours with the flag for coherent rays.
  void nearest_in_packets(std::span<const BenchRay> rays, std::span<BenchHit> hits) const;
  void rebuild();

 private:
  RTCDevice device_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace ps::bench
