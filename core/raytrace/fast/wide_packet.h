#pragma once
#include <array>

#include "accel/wide_bvh.h"
#include "options/settings.h"
#include "raytrace/base/ray.h"
#include "raytrace/fast/wide_search.h"

namespace ps {

/// Eight rays that go through a wide tree together: one lane for each. Of use only while they stay together, as eye
/// rays of neighbouring pixels do. t and weights are those of single rays, to the last bit.
inline constexpr std::size_t packet_width = 8;

struct alignas(32) WidePacket {
  using Lanes = std::array<float, packet_width>;
  std::array<Lanes, 3> origin, direction;  ///< by axis
  Lanes t_min, t_max;
  float pad = 0;                           ///< as in WideQuery
  float triangle_epsilon = 0;              ///< for Moeller-Trumbore
  const TriangleFilter* filter = nullptr;  ///< as in WideQuery
};

/// Best hits known so far, lane by lane; primitive -1 = none, and then t = t_max.
struct alignas(32) WidePacketHits {
  WidePacket::Lanes t;
  std::array<std::int32_t, packet_width> primitive;
  std::array<WidePacket::Lanes, 3> weights;
};

/// May these rays (from 1 to packet_width) go together? They must point into one octant, mostly along one axis, and not
/// start on a surface.
bool suits_packet(const Ray<float>* rays, std::size_t count);

using PacketSearch = void (*)(const WideBvh& bvh, const WidePacket& packet, WidePacketHits& hits, WideCount& count);
/// Bit i: ray i may meet something in the box, which is grown as in WideQuery. `centre`: as in WideBvh.
using PacketBoxTest = unsigned (*)(const Box<float>& box, const WidePacket& packet, const Vec3f& centre);

struct PacketSearches {
  PacketSearch nearest = nullptr;
  PacketBoxTest meets = nullptr;
};

/// The functions for this test on this processor, or none.
PacketSearches packet_searches(Simd simd, SimdTriangleTest test);

}  // namespace ps
