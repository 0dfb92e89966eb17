#pragma once
#include <array>
#include <span>

#include "options/settings.h"
#include "raytrace/base/ray.h"
#include "raytrace/fast/wide_geometry.h"
#include "raytrace/fast/wide_search.h"

namespace ps {

/// Rays that go through a wide tree together: one lane for each, as many as a register holds. Of use only while they
/// stay together, as eye rays of neighbouring pixels do. t and weights are those of single rays, to the last bit.
inline constexpr std::size_t most_in_packet = 16;
/// As many rays as are best made before the first of them are searched for: numbers that the processor has only just
/// written one by one cannot be read side by side at once.
inline constexpr std::size_t rays_at_once = 64;

struct alignas(64) WidePacket {
  using Lanes = std::array<float, most_in_packet>;
  std::array<Lanes, 3> origin, direction;  ///< by axis
  Lanes t_min, t_max;
  std::size_t count = 0;                   ///< lanes that hold a ray of their own
  float pad = 0;                           ///< as in WideQuery
  float triangle_epsilon = 0;              ///< for Moeller-Trumbore
  bool one_origin = false;                 ///< all rays start at one point
  const TriangleFilter* filter = nullptr;  ///< as in WideQuery
};

/// Best hits known so far, lane by lane; primitive -1 = none, and then t = t_max.
struct alignas(64) WidePacketHits {
  WidePacket::Lanes t;
  std::array<std::int32_t, most_in_packet> primitive;
  std::array<WidePacket::Lanes, 3> weights;
};

/// Puts rays (from 1 to PacketSearches::width) side by side, the last one in the lanes that are left over. False if
/// they cannot go together: they must point into one octant, mostly along one axis, not start on a surface, and none
/// may have a direction that is tiny beside its reach, or a number that is not finite. `padding`: WideQuery::pad for a
/// reach of 1.
using PacketMaker = bool (*)(std::span<const Ray<float>> rays, const SeenFrom<float>& seen, float padding,
                             WidePacket& packet);
using PacketSearch = void (*)(const WideBvh& bvh, const WidePacket& packet, WidePacketHits& hits, WideCount& count);
/// Bit i: ray i may meet something in the box, which is grown as in WideQuery. `centre`: as in WideBvh.
using PacketBoxTest = unsigned (*)(const Box<float>& box, const WidePacket& packet, const Vec3f& centre);

struct PacketSearches {
  std::size_t width = 0;  ///< lanes in use
  PacketMaker make = nullptr;
  PacketSearch nearest = nullptr;
  PacketBoxTest meets = nullptr;
};

/// The functions for this test on this processor, or none.
PacketSearches packet_searches(Simd simd, SimdTriangleTest test);

}  // namespace ps
