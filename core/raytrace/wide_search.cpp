#include "raytrace/wide_search.h"

#include <array>

#include "raytrace/triangle_watertight.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/wide_search.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raytrace/wide_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

using Boxes = hn::CappedTag<float, wide_width>;

/// A child that waits for its turn.
struct Waiting {
  float near;
  std::uint32_t child, blocks;
};

/// The ray's numbers in all lanes, and which planes of a box it meets first.
struct BoxRay {
  explicit BoxRay(const SlabRay<float>& slabs) {
    // Rounding of the reciprocal, of the two operations at each end, and of `grow` itself: see slab_test().
    constexpr float grow = 1 + 10 * std::numeric_limits<float>::epsilon();
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      entering[k] = slabs.entering[axis];
      leaving[k] = slabs.leaving[axis];
      inverse[k] = slabs.inverse[axis];
      inverse_far[k] = slabs.inverse[axis] * grow;
      near_plane[k] = 2 * k + (slabs.negative[k] ? 1 : 0);
      far_plane[k] = 2 * k + (slabs.negative[k] ? 0 : 1);
    }
  }
  std::array<float, 3> entering, leaving, inverse, inverse_far;
  std::array<std::size_t, 3> near_plane, far_plane;
};

/// Bit i is set if the ray enters child i before `limit`; `near` gets where. The second operand of Max and Min is what
/// x86 gives for NaN (0 * infinity), which leaves the range as it is.
HWY_INLINE unsigned enter_children(const WideNode& node, const BoxRay& ray, float limit, float* HWY_RESTRICT near) {
  const Boxes d;
  unsigned bits = 0;
  for (std::size_t lane = 0; lane < wide_width; lane += hn::Lanes(d)) {
    auto first = hn::Zero(d);
    auto last = hn::Set(d, limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto near_plane = hn::Load(d, node.planes[ray.near_plane[axis]] + lane);
      const auto far_plane = hn::Load(d, node.planes[ray.far_plane[axis]] + lane);
      const auto in = hn::Mul(hn::Sub(near_plane, hn::Set(d, ray.entering[axis])), hn::Set(d, ray.inverse[axis]));
      const auto out = hn::Mul(hn::Sub(far_plane, hn::Set(d, ray.leaving[axis])), hn::Set(d, ray.inverse_far[axis]));
      first = hn::Max(in, first);
      last = hn::Min(out, last);
    }
    hn::Store(first, d, near + lane);
    std::uint8_t part[8] = {};
    hn::StoreMaskBits(d, hn::Le(first, last), part);
    bits |= static_cast<unsigned>(part[0]) << lane;
  }
  return bits;
}

/// The nearer child is followed, the others wait with the nearest on top; equal ones in the order of their places.
HWY_INLINE Waiting order_children(const WideNode& node, unsigned bits, const float* near, Waiting*& top) {
  Waiting* const bottom = top;
  Waiting next{};
  for (bool started = false; bits != 0; bits &= bits - 1) {
    const int slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
    Waiting entry{near[slot], node.child[slot], node.blocks[slot]};
    if (!started) {
      next = entry;
      started = true;
      continue;
    }
    if (entry.near < next.near) std::swap(entry, next);
    Waiting* place = top++;
    for (; place > bottom && place[-1].near < entry.near; --place) place[0] = place[-1];
    *place = entry;
  }
  return next;
}

template <TriangleTest test, bool any>
void search(const WideBvh& bvh, const WideQuery& query, Hit<float>& best, WideCount& count) {
  const BoxRay boxes(query.slabs);
  const BlockRay<test> triangles(query);
  std::array<Waiting, WideBvh::most_waiting> stack;
  Waiting* top = stack.data();
  Waiting current{0, 0, 0};
  std::uint64_t nodes = 0, tests = 0;
  while (true) {
    if (current.blocks == 0) {
      const WideNode& node = bvh.nodes[current.child];
      ++nodes;
      HWY_ALIGN float near[wide_width];
      const unsigned bits = enter_children(node, boxes, best.t, near);
      if (bits != 0) {
        current = order_children(node, bits, near, top);
        continue;
      }
    } else {
      const TriangleBlock* const blocks = &bvh.blocks[current.child];
      tests += wide_block_width * current.blocks;
      bool found = false;
      for (std::uint32_t i = 0; i < current.blocks; ++i) found |= triangles.test(blocks[i], query, best);
      if (any && found) break;
    }
    do {
      if (top == stack.data()) {
        count.nodes += nodes;
        count.triangles += tests;
        return;
      }
      current = *--top;
    } while (current.near > best.t);
  }
  count.nodes += nodes;
  count.triangles += tests;
}

}  // namespace

WideSearches wide_searches(TriangleTest test) {
  switch (test) {
  case TriangleTest::watertight:
    return {search<TriangleTest::watertight, false>, search<TriangleTest::watertight, true>};
  case TriangleTest::moeller_trumbore:
    return {search<TriangleTest::moeller_trumbore, false>, search<TriangleTest::moeller_trumbore, true>};
  case TriangleTest::barycentric:
  case TriangleTest::cross_products:
    return {};
  }
  return {};
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

WideSearches wide_searches(Simd simd, TriangleTest test) {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  const auto may_use = [&](Simd target, std::int64_t bit) {
    return (have & bit) != 0 && (simd == Simd::automatic || static_cast<int>(simd) >= static_cast<int>(target));
  };
  if (simd == Simd::off) return {};
  if (may_use(Simd::avx512, HWY_AVX3)) return N_AVX3::wide_searches(test);
  if (may_use(Simd::avx2, HWY_AVX2)) return N_AVX2::wide_searches(test);
  if (may_use(Simd::sse4, HWY_SSE4)) return N_SSE4::wide_searches(test);
#else
  static_cast<void>(simd);
  static_cast<void>(test);
#endif
  return {};
}

}  // namespace ps
#endif
