// One ray against the eight boxes of a node, and the stack of children that wait.
#if defined(PIXELSCOPE_WIDE_NODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_WIDE_NODES_INL_H_
#undef PIXELSCOPE_WIDE_NODES_INL_H_
#else
#define PIXELSCOPE_WIDE_NODES_INL_H_
#endif

#include <array>
#include <cmath>

#include "accel/slab.h"
#include "hwy/highway.h"
#include "raytrace/fast/wide_children-inl.h"
#include "raytrace/fast/wide_search.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Boxes = hn::CappedTag<float, wide_width>;
using Words = hn::Rebind<std::uint32_t, Boxes>;
using Boxes8 = hn::Vec<Boxes>;
inline constexpr std::size_t box_lanes = HWY_TARGET == HWY_SSE4 ? 4 : 8;

/// The ray's numbers as a node's test wants them: t of a plane is plane * inverse - from. With u = 2^-24, the rounding
/// of the reciprocal, of `from` and of t moves a plane by no more than 6 u times the largest coordinate (of boxes and
/// origin), that of planes and origin as they are seen from WideBvh::centre by 2 u; WideQuery::pad is at least 32 u
/// times that: a quarter more covers it.
struct BoxRay {
  /// x, y and z side by side, and a lane that means nothing.
  using Axes = hn::Vec<hn::Full128<float>>;

  HWY_INLINE BoxRay(const WideQuery& query, const Vec3f& centre) {
    const hn::Full128<float> d;
    const Vec3f& along = query.ray.direction;
    const Axes direction = axes(along), origin = hn::Sub(axes(query.ray.origin), axes(centre));
    const Axes sign = hn::And(direction, hn::SignBit(d));
    // A component of (about) zero would make 0 * infinity. This little moves no point of the ray by more than `pad`.
    const float least = 1e-20f * std::max(std::max(std::abs(along.x), std::abs(along.y)), std::abs(along.z));
    const Axes size = hn::Max(hn::Abs(direction), hn::Set(d, least));
    const Axes inverse = hn::Or(hn::Div(hn::Set(d, 1.0f), size), sign);
    const Axes grown = hn::Or(hn::Set(d, 1.25f * query.pad), sign);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::MaskFromVec(direction), bytes);
    set(bytes[0] & 7u, inverse, hn::Mul(hn::Add(origin, grown), inverse), hn::Mul(hn::Sub(origin, grown), inverse));
  }
  /// Boxes, for a ray that is ready for them, are grown as much again, for the rounding of the products here.
  HWY_INLINE explicit BoxRay(const SlabRay<float>& ray) {
    const float least = std::min(std::min(std::abs(ray.inverse.x), std::abs(ray.inverse.y)), std::abs(ray.inverse.z));
    Vec3f inverse, near, far;
    unsigned down = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const bool negative = ray.negative[static_cast<std::size_t>(axis)];
      const float size = std::min(std::abs(ray.inverse[axis]), 1e20f * least);
      const float again = (ray.entering[axis] - ray.leaving[axis]) / 2;
      inverse[axis] = negative ? -size : size;
      near[axis] = (ray.entering[axis] + again) * inverse[axis];
      far[axis] = (ray.leaving[axis] - again) * inverse[axis];
      down |= negative ? 1u << axis : 0u;
    }
    set(down, axes(inverse), axes(near), axes(far));
  }
  HWY_INLINE void set(unsigned down, Axes inverse, Axes near, Axes far) {
    octant = down;
    plane_x = (down & 1u) * wide_width;
    plane_y = (2 + (down >> 1 & 1u)) * wide_width;
    plane_z = (4 + (down >> 2)) * wide_width;
    spread(inverse, inverse_x, inverse_y, inverse_z);
    spread(near, near_x, near_y, near_z);
    spread(far, far_x, far_y, far_z);
  }
  /// By way of registers: a vector read from numbers just written would wait until they reach the cache.
  HWY_INLINE static Axes axes(const Vec3f& v) {
    Axes result;
    result.raw = decltype(result.raw){v.x, v.y, v.z, 0.0f};
    return result;
  }
  HWY_INLINE static void spread(Axes axes, Boxes8& x, Boxes8& y, Boxes8& z) {
    const Boxes d;
    x = hn::Set(d, hn::GetLane(axes));
    y = hn::Set(d, hn::GetLane(hn::Broadcast<1>(axes)));
    z = hn::Set(d, hn::GetLane(hn::Broadcast<2>(axes)));
  }
  Boxes8 inverse_x, inverse_y, inverse_z, near_x, near_y, near_z, far_x, far_y, far_z;
  std::size_t plane_x, plane_y, plane_z;  ///< where in WideNode::planes the planes are that the ray meets first
  unsigned octant;                        ///< of the direction: a place in WideNode::order
};

/// Where the ray enters (`first`) and leaves (`last`) boxes of a node from `lane` on, within [0, limit]. The second
/// operand of Max and Min is what x86 gives for NaN, which leaves the range as it is.
struct BoxSpan {
  Boxes8 first, last;
};
HWY_INLINE BoxSpan box_span(const WideNode& node, const BoxRay& ray, Boxes8 limit, std::size_t lane) {
  const Boxes d;
  const float* const planes = &node.planes[0][0] + lane;
  const auto plane = [&](std::size_t place) { return hn::Load(d, planes + place); };
  const Boxes8 in_x = hn::MulSub(plane(ray.plane_x), ray.inverse_x, ray.near_x);
  const Boxes8 in_y = hn::MulSub(plane(ray.plane_y), ray.inverse_y, ray.near_y);
  const Boxes8 in_z = hn::MulSub(plane(ray.plane_z), ray.inverse_z, ray.near_z);
  const Boxes8 out_x = hn::MulSub(plane(ray.plane_x ^ wide_width), ray.inverse_x, ray.far_x);
  const Boxes8 out_y = hn::MulSub(plane(ray.plane_y ^ wide_width), ray.inverse_y, ray.far_y);
  const Boxes8 out_z = hn::MulSub(plane(ray.plane_z ^ wide_width), ray.inverse_z, ray.far_z);
  return {hn::Max(in_z, hn::Max(in_y, hn::Max(in_x, hn::Zero(d)))),
          hn::Min(out_z, hn::Min(out_y, hn::Min(out_x, limit)))};
}

/// Children that wait for their turn, with the t at which the ray enters them.
struct Waiting {
  std::array<float, WideBvh::most_waiting + wide_width> near;  // a whole vector is written at the top
  std::array<WideChild, WideBvh::most_waiting + wide_width> child;
};

/// For each set of places, bit i meaning place i: its places, the last first. What is behind them means nothing.
struct PlacesOfBits {
  std::array<std::array<std::uint8_t, wide_width>, 256> places{};
  constexpr PlacesOfBits() {
    for (std::size_t bits = 0; bits < places.size(); ++bits) {
      std::size_t count = 0;
      for (std::uint8_t place = wide_width; place-- > 0;)
        if ((bits >> place & 1u) != 0) places[bits][count++] = place;
    }
  }
};
inline constexpr PlacesOfBits far_to_near;

/// Any hit is as good as another: then it costs more to order the children than it saves.
enum class Visits { by_slot, near_to_far };

/// Enters those children of a node that the ray meets before `limit`: one becomes `next`, the others wait on top of the
/// stack, the sooner the higher. False if there is none. From near to far, in the order for the ray's octant, or by
/// slot; then Waiting::near is not to be read.
template <Visits visits>
HWY_INLINE bool enter_node(const WideNode& node, const BoxRay& ray, Boxes8 limit, Waiting& waiting, std::size_t& top,
                           WideChild& next) {
  const Boxes d;
  if constexpr (box_lanes == 8) {
    const Words w;
    hwy::Prefetch(node.child);  // a line of its own, read later than the planes
    const BoxSpan span = box_span(node, ray, limit, 0);
    const auto entered = hn::Le(span.first, span.last);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, entered, bytes);
    const unsigned bits = bytes[0];
    if (bits == 0) return false;
    if ((bits & (bits - 1)) == 0) {
      next = node.child[hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)];
      return true;
    }
    // The places of the boxes entered, the soonest last; then what is there.
    const hn::Rebind<std::uint8_t, Words> b;
    const auto places_of = [&](unsigned set)
                               HWY_ATTR { return hn::PromoteTo(w, hn::LoadU(b, far_to_near.places[set].data())); };
    std::size_t soonest = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
    auto slots = places_of(bits);
    if constexpr (visits == Visits::near_to_far) {
      const std::uint32_t packed = node.order[ray.octant];
      const auto order = slots_in_order(packed);
      const auto chosen = hn::TableLookupLanes(hn::VecFromMask(d, entered), hn::IndicesFromVec(d, order));
      hn::StoreMaskBits(d, hn::MaskFromVec(chosen), bytes);
      soonest = slot_at(packed, hwy::Num0BitsBelowLS1Bit_Nonzero32(bytes[0]));
      slots = hn::TableLookupLanes(order, hn::IndicesFromVec(w, places_of(bytes[0])));
      hn::StoreU(hn::TableLookupLanes(span.first, hn::IndicesFromVec(d, slots)), d, waiting.near.data() + top);
    }
    hn::StoreU(hn::TableLookupLanes(hn::Load(w, node.child), hn::IndicesFromVec(w, slots)), w,
               waiting.child.data() + top);
    next = node.child[soonest];
    top += hwy::PopCount(bits) - 1;
    return true;
  } else {
    HWY_ALIGN float first[wide_width], last[wide_width];
    for (std::size_t lane = 0; lane < wide_width; lane += box_lanes) {
      const BoxSpan span = box_span(node, ray, limit, lane);
      hn::Store(span.first, d, first + lane);
      hn::Store(span.last, d, last + lane);
    }
    const std::size_t before = top;
    for (std::size_t place = wide_width; place-- > 0;) {
      const std::size_t slot = visits == Visits::by_slot ? place : slot_at(node.order[ray.octant], place);
      waiting.near[top] = first[slot];
      waiting.child[top] = node.child[slot];
      top += first[slot] <= last[slot] ? 1 : 0;
    }
    if (top == before) return false;
    next = waiting.child[--top];
    return true;
  }
}

/// Follows a ray through a tree, from near to far: leaf(first, count) is called for the leaves that it meets before
/// `best`, and says whether `best` has improved; with `ends`, that is the end. `blocks` is where leaves have theirs.
template <bool ends, class Block, class Leaf>
HWY_INLINE void walk_nodes(const WideNode* nodes, const Block* blocks, const BoxRay& boxes, const Hit<float>& best,
                           std::uint64_t& visits, Leaf&& leaf) {
  constexpr Visits order = ends ? Visits::by_slot : Visits::near_to_far;
  Waiting waiting;
  std::size_t top = 0;
  WideChild current = 0;
  std::uint64_t node_visits = 0;
  auto limit = hn::Set(Boxes(), best.t);
  while (true) {
    while (!is_leaf(current)) {
      ++node_visits;
      if (enter_node<order>(nodes[current], boxes, limit, waiting, top, current)) {
        if (top != 0) fetch_soon(nodes, blocks, waiting.child[top - 1]);
        continue;
      }
      do {
        if (top == 0) goto done;
        --top;
      } while (!ends && waiting.near[top] > best.t);
      current = waiting.child[top];
    }
    if (leaf(leaf_first(current), leaf_count(current))) {
      if (ends) goto done;
      limit = hn::Set(Boxes(), best.t);
    }
    do {
      if (top == 0) goto done;
      --top;
    } while (!ends && waiting.near[top] > best.t);
    current = waiting.child[top];
  }
done:
  visits += node_visits;
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
