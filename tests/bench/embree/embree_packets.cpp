#include <algorithm>
#include <array>

#include "bench/embree/embree_scene.h"

namespace ps::bench {

void EmbreeScene::nearest_in_packets(std::span<const BenchRay> rays, std::span<BenchHit> hits) const {
  constexpr std::size_t width = 16;
  RTCRayHit16 packet{};
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t count = std::min(width, rays.size() - first);
    alignas(64) std::array<int, width> valid{};
    for (std::size_t lane = 0; lane < count; ++lane) {
      const BenchRay& ray = rays[first + lane];
      valid[lane] = -1;
      packet.ray.org_x[lane] = ray.origin.x;
      packet.ray.org_y[lane] = ray.origin.y;
      packet.ray.org_z[lane] = ray.origin.z;
      packet.ray.tnear[lane] = 0;
      packet.ray.dir_x[lane] = ray.direction.x;
      packet.ray.dir_y[lane] = ray.direction.y;
      packet.ray.dir_z[lane] = ray.direction.z;
      packet.ray.tfar[lane] = ray.t_max;
      packet.ray.mask[lane] = 0xffffffffu;
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    embree::nearest_of_packet(scene_, valid.data(), packet);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const bool found = packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
      hits[first + lane] = {found ? packet.hit.primID[lane] : no_hit, packet.ray.tfar[lane]};
    }
  }
}

}  // namespace ps::bench
