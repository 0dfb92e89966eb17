#include "raytrace/fast/wide_packet.h"

#include <cstddef>

#include "options/simd_choice.h"

// This file is compiled once for each SIMD target. Only the two with eight and sixteen lanes are kept.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/wide_packet.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raytrace/fast/packet_boxes-inl.h"
#include "raytrace/fast/packet_triangles-inl.h"
#include "raytrace/fast/wide_children-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace packets {
namespace {

unsigned meets(const Box<float>& box, const WidePacket& packet, const Vec3f& centre) {
  const D d;
  const Vec3f low = box.low - centre, high = box.high - centre;
  const float planes[6] = {low.x, high.x, low.y, high.y, low.z, high.z};
  const auto plane = [&](std::size_t index) HWY_ATTR { return all(planes[index]); };
  const LaneSpan span = span_in_box(BoxAxes(packet, centre), hn::Load(d, packet.t_max.data()), plane);
  return bits_of(d, hn::Le(span.first, span.last));
}

/// A ray's numbers from Ray::origin on: x, y, z of the origin, of the direction, t_min, t_max.
struct Numbers {
  static constexpr std::size_t count = 8;
  using Tag = hn::CappedTag<float, count>;
  using Vector = hn::Vec<Tag>;
};
/// Rows become columns.
HWY_INLINE void transpose(Numbers::Vector (&rows)[Numbers::count]) {
  const Numbers::Tag d;
  const hn::RepartitionToWide<Numbers::Tag> pairs;
#pragma GCC unroll 2
  for (std::size_t i = 0; i < Numbers::count; i += 4) {
    const auto low_a = hn::BitCast(pairs, hn::InterleaveLower(d, rows[i], rows[i + 1]));
    const auto high_a = hn::BitCast(pairs, hn::InterleaveUpper(d, rows[i], rows[i + 1]));
    const auto low_b = hn::BitCast(pairs, hn::InterleaveLower(d, rows[i + 2], rows[i + 3]));
    const auto high_b = hn::BitCast(pairs, hn::InterleaveUpper(d, rows[i + 2], rows[i + 3]));
    rows[i] = hn::BitCast(d, hn::InterleaveLower(pairs, low_a, low_b));
    rows[i + 1] = hn::BitCast(d, hn::InterleaveUpper(pairs, low_a, low_b));
    rows[i + 2] = hn::BitCast(d, hn::InterleaveLower(pairs, high_a, high_b));
    rows[i + 3] = hn::BitCast(d, hn::InterleaveUpper(pairs, high_a, high_b));
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < 4; ++i) {
    const auto upper = hn::ConcatUpperUpper(d, rows[i + 4], rows[i]);
    rows[i] = hn::ConcatLowerLower(d, rows[i + 4], rows[i]);
    rows[i + 4] = upper;
  }
}

HWY_INLINE bool all_or_none(M mask) {
  const D d;
  return hn::AllTrue(d, mask) || hn::AllFalse(d, mask);
}

bool make(std::span<const Ray<float>> rays, const SeenFrom<float>& seen, float padding, WidePacket& packet) {
  static_assert(offsetof(Ray<float>, direction) == 12 && offsetof(Ray<float>, t_min) == 24 &&
                offsetof(Ray<float>, t_max) == 28);
  const D d;
  WidePacket::Lanes* const lanes[Numbers::count] = {&packet.origin[0],    &packet.origin[1],    &packet.origin[2],
                                                    &packet.direction[0], &packet.direction[1], &packet.direction[2],
                                                    &packet.t_min,        &packet.t_max};
  bool free = true;
  Numbers::Vector numbers[width / Numbers::count][Numbers::count];
#pragma GCC unroll 16
  for (std::size_t i = 0; i < width; ++i) {
    const Ray<float>& ray = rays[std::min(i, rays.size() - 1)];
    numbers[i / Numbers::count][i % Numbers::count] = hn::LoadU(Numbers::Tag(), &ray.origin.x);
    free = free && ray.start == no_primitive;
  }
#pragma GCC unroll 2
  for (auto& rows : numbers) transpose(rows);
  V columns[Numbers::count];
#pragma GCC unroll 8
  for (std::size_t i = 0; i < Numbers::count; ++i) {
#if HWY_TARGET == HWY_AVX3
    columns[i] = hn::Combine(d, numbers[1][i], numbers[0][i]);
#else
    columns[i] = numbers[0][i];
#endif
    hn::Store(columns[i], d, lanes[i]->data());
  }
  const auto [ox, oy, oz, dx, dy, dz, t_min, t_max] = columns;
  const V zero = hn::Zero(d);
  const auto sum_times_0 = [&](V x, V y, V z) HWY_ATTR { return hn::Mul(hn::Add(hn::Add(x, y), z), zero); };
  const M finite = hn::Eq(hn::Add(sum_times_0(ox, oy, oz), sum_times_0(dx, dy, dz)), zero);
  const bool one_octant =
      all_or_none(hn::MaskFromVec(dx)) && all_or_none(hn::MaskFromVec(dy)) && all_or_none(hn::MaskFromVec(dz));
  const V x = hn::Abs(dx), y = hn::Abs(dy), z = hn::Abs(dz);
  const M along_x = hn::And(hn::Gt(x, y), hn::Gt(x, z)), along_y = hn::AndNot(hn::Gt(x, y), hn::Gt(y, z));
  const auto from = [&](V origin, float centre) HWY_ATTR { return hn::Abs(hn::Sub(origin, all(centre))); };
  const V place = hn::Max(hn::Max(from(ox, seen.centre.x), from(oy, seen.centre.y)), from(oz, seen.centre.z));
  const V reach = hn::Max(place, all(seen.reach));
  const M aimed = hn::Lt(reach, hn::Mul(all(1e15f), hn::Max(hn::Max(x, y), z)));
  if (!free || !one_octant || !all_or_none(along_x) || !all_or_none(along_y) || !hn::AllTrue(d, hn::And(finite, aimed)))
    return false;
  packet.count = rays.size();
  packet.pad = padding * hn::GetLane(hn::MaxOfLanes(d, reach));
  const auto alike = [&](V origin) HWY_ATTR { return hn::Eq(origin, all(hn::GetLane(origin))); };
  packet.one_origin = hn::AllTrue(d, hn::And(hn::And(alike(ox), alike(oy)), alike(oz)));
  return true;
}

/// The places, in an order of WideNode::order, of the slots in `slots`; bit i is place or slot i.
HWY_INLINE unsigned places_of(std::uint32_t packed, unsigned slots) {
  const Slots d;
  const auto order = slots_in_order(packed);
  const auto bit = hn::And(hn::Set(d, slots), hn::Shl(hn::Set(d, 1u), order));
  return bits_of(d, hn::Ne(bit, hn::Zero(d)));
}

template <SimdTriangleTest test, Origins origins>
HWY_NOINLINE void search_from(const WideBvh& bvh, const WidePacket& packet, WidePacketHits& hits, WideCount& count) {
  const D d;
  const I i;
  const BoxAxes rays(packet, bvh.centre);
  const Beam beam(packet, bvh.centre, rays);
  const unsigned own = (1u << packet.count) - 1;
  float limit = hn::GetLane(hn::MaxOfLanes(d, hn::Load(d, hits.t.data())));
  if (origins == Origins::one && beam.meets(bvh.nodes[0].planes, limit) == 0) {  // as many do, beside the models
    count.nodes += hwy::PopCount(own);
    return;
  }
  const std::size_t octant = (rays.x.near_plane & 1u) | (rays.y.near_plane & 1u) << 1 | (rays.z.near_plane & 1u) << 2;
  const Triangles<test, origins> triangles(packet);
  Best best{
      hn::Load(d, hits.t.data()),
      hn::Load(i, hits.primitive.data()),
      {hn::Load(d, hits.weights[0].data()), hn::Load(d, hits.weights[1].data()), hn::Load(d, hits.weights[2].data())}};

  struct Waiting {
    HWY_ALIGN float near[width];  ///< infinite where the lane passes by
    WideChild child;
  };
  std::array<Waiting, WideBvh::most_waiting + wide_width> stack;
  std::size_t top = 0;
  WideChild current = 0;
  // The lanes whose rays are in the box of `current` before what they have met. Work counts for these alone: it is what
  // the same rays do one by one.
  unsigned active = own;
  while (true) {
    if (is_leaf(current)) {
      const TriangleBlock* const blocks = &bvh.blocks[leaf_first(current)];
      const std::uint32_t number = leaf_count(current);
      count.triangles += hwy::PopCount(active & own) * number * block_width;
      bool improved = false;
      for (std::uint32_t b = 0; b < number; ++b) {
        unsigned perhaps =
            origins == Origins::one ? perhaps_met(blocks[b], beam, bvh.centre, limit) : filled(blocks[b]);
        if (perhaps == 0) continue;
        typename Triangles<test, origins>::Shared shared;
        triangles.share(blocks[b], shared);
        for (; perhaps != 0; perhaps &= perhaps - 1)
          improved |= triangles.test(blocks[b], shared, hwy::Num0BitsBelowLS1Bit_Nonzero32(perhaps), best);
      }
      if (improved) limit = hn::GetLane(hn::MaxOfLanes(d, best.t));
    } else {
      const WideNode& node = bvh.nodes[current];
      count.nodes += hwy::PopCount(active & own);
      const std::size_t before = top;
      const std::uint32_t order = node.order[octant];
      for (unsigned places = places_of(order, origins == Origins::one ? beam.meets(node.planes, limit) : 0xffu);
           places != 0;) {
        const std::size_t place = 31 - hwy::Num0BitsAboveMS1Bit_Nonzero32(places);  // the nearest last
        places ^= 1u << place;
        const std::uint32_t slot = slot_at(order, place);
        const auto plane = [&](std::size_t index) HWY_ATTR { return all(node.planes[index][slot]); };
        const LaneSpan span = span_in_box(rays, best.t, plane);
        const M entered = hn::Le(span.first, span.last);
        if (hn::AllFalse(d, entered)) continue;
        active = bits_of(d, entered);
        hn::Store(hn::IfThenElse(entered, span.first, hn::Inf(d)), d, stack[top].near);
        const WideChild child = node.child[slot];
        stack[top++].child = child;
        fetch_soon(bvh.nodes.data(), bvh.blocks.data(), child);
      }
      if (top > before) {
        current = stack[--top].child;
        continue;
      }
    }
    active = 0;
    while (top > 0 && active == 0) {
      --top;
      const V near = hn::Load(d, stack[top].near);
      active = bits_of(d, hn::And(hn::Le(near, best.t), hn::Lt(near, hn::Inf(d))));
    }
    if (active == 0) break;
    current = stack[top].child;
  }
  hn::Store(best.t, d, hits.t.data());
  hn::Store(best.primitive, i, hits.primitive.data());
  for (std::size_t k = 0; k < 3; ++k) hn::Store(best.weights[k], d, hits.weights[k].data());
}

template <SimdTriangleTest test>
void search(const WideBvh& bvh, const WidePacket& packet, WidePacketHits& hits, WideCount& count) {
  const auto chosen = packet.one_origin ? search_from<test, Origins::one> : search_from<test, Origins::many>;
  chosen(bvh, packet, hits, count);
}

}  // namespace
}  // namespace packets

PacketSearches packet_searches(SimdTriangleTest test) {
  using namespace packets;
  switch (test) {
  case SimdTriangleTest::watertight:
    return {width, make, search<SimdTriangleTest::watertight>, meets};
  case SimdTriangleTest::moeller_trumbore:
    return {width, make, search<SimdTriangleTest::moeller_trumbore>, meets};
  }
  return {};
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

PacketSearches packet_searches(Simd simd, [[maybe_unused]] SimdTriangleTest test) {
  return PS_CHOSEN_WIDE_KERNEL(PacketSearches, simd, packet_searches(test));
}

}  // namespace ps
#endif
