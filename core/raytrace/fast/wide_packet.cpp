#include "raytrace/fast/wide_packet.h"

#include "options/simd_choice.h"
#include "raytrace/clear/triangle_watertight.h"

// This file is compiled once for each SIMD target. Only the two with eight lanes are kept.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/wide_packet.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "math/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, packet_width>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using P = Vec3Lanes<D>;

HWY_INLINE V all(float value) { return hn::Set(D(), value); }

/// A lane's best hit.
struct Best {
  V t;
  hn::Vec<I> primitive;
  V weights[3];
};

/// Takes t and weights in the lanes of `inside` that are in range and win: nearer, or as near with a lower index.
HWY_INLINE void take(M inside, V t, V w0, V w1, V w2, std::uint32_t primitive, V t_min, V t_max, Best& best) {
  const I i;
  const auto mine = hn::Set(i, static_cast<std::int32_t>(primitive));
  const M lower = hn::RebindMask(D(), hn::Gt(best.primitive, mine));
  const M wins = hn::Or(hn::Lt(t, best.t), hn::And(hn::Eq(t, best.t), lower));
  const M taken = hn::And(hn::And(inside, wins), hn::And(hn::Gt(t, t_min), hn::Lt(t, t_max)));
  best.t = hn::IfThenElse(taken, t, best.t);
  best.primitive = hn::IfThenElse(hn::RebindMask(i, taken), mine, best.primitive);
  best.weights[0] = hn::IfThenElse(taken, w0, best.weights[0]);
  best.weights[1] = hn::IfThenElse(taken, w1, best.weights[1]);
  best.weights[2] = hn::IfThenElse(taken, w2, best.weights[2]);
}

Vec3f corner(const TriangleBlock<wide_block_width>& block, int corner, std::uint32_t lane) {
  const auto& axes = block.corner[corner];
  return {axes[0][lane], axes[1][lane], axes[2][lane]};
}

/// Those of the rays in `inside` for which the triangle counts.
HWY_NOINLINE M filtered(M inside, const TriangleBlock<wide_block_width>& block, std::uint32_t lane,
                        const WidePacket& packet) {
  const D d;
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, inside, bits);
  const TracedTriangle<float> triangle{corner(block, 0, lane), corner(block, 1, lane), corner(block, 2, lane), -1};
  for (std::size_t i = 0; i < packet_width; ++i) {
    const Vec3f direction{packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
    const unsigned bit = 1u << i;
    if ((bits[0] & bit) != 0 && !packet.filter->counts(direction, block.primitive[lane], triangle))
      bits[0] = static_cast<std::uint8_t>(bits[0] & ~bit);
  }
  return hn::LoadMaskBits(d, bits);
}

template <SimdTriangleTest test>
struct Triangles;

/// triangle_moeller_trumbore.h for eight rays and one triangle.
template <>
struct Triangles<SimdTriangleTest::moeller_trumbore> {
  explicit Triangles(const WidePacket& rays) : packet(rays), epsilon(all(rays.triangle_epsilon)) {
    const D d;
    origin = {hn::Load(d, packet.origin[0].data()), hn::Load(d, packet.origin[1].data()),
              hn::Load(d, packet.origin[2].data())};
    direction = {hn::Load(d, packet.direction[0].data()), hn::Load(d, packet.direction[1].data()),
                 hn::Load(d, packet.direction[2].data())};
    t_min = hn::Load(d, packet.t_min.data());
    t_max = hn::Load(d, packet.t_max.data());
  }
  HWY_INLINE void test(const TriangleBlock<wide_block_width>& block, std::uint32_t lane, Best& best) const {
    const D d;
    const V zero = hn::Zero(d), one = all(1);
    const Vec3f a = corner(block, 0, lane);
    const P edge_b = same_in_lanes<D>(corner(block, 1, lane) - a),
            edge_c = same_in_lanes<D>(corner(block, 2, lane) - a);
    const P p = cross(direction, edge_c);
    const V determinant = dot(edge_b, p);
    const P s = subtract(origin, same_in_lanes<D>(a));
    const P q = cross(s, edge_b);
    const V u_part = dot(s, p), v_part = dot(direction, q), t_part = dot(edge_c, q);
    // Most rays can be rejected before the divisions. The decision falls after them.
    const V sign = hn::And(determinant, hn::SignBit(d));
    const V size = hn::Xor(determinant, sign), slack = hn::Mul(size, all(1e-6f));
    const V u_size = hn::Xor(u_part, sign), v_size = hn::Xor(v_part, sign);
    const V rest = hn::Sub(hn::Sub(size, u_size), v_size);
    if (hn::AllFalse(d, hn::Ge(hn::Add(hn::Min(hn::Min(u_size, v_size), rest), slack), zero))) return;
    const V u = hn::Div(u_part, determinant), v = hn::Div(v_part, determinant), t = hn::Div(t_part, determinant);
    const M positive = hn::And(hn::Ge(u, zero), hn::Ge(v, zero));
    M inside = hn::And(hn::And(hn::Gt(size, epsilon), positive), hn::Le(hn::Add(u, v), one));
    if (HWY_UNLIKELY(packet.filter != nullptr)) inside = filtered(inside, block, lane, packet);
    take(inside, t, hn::Sub(hn::Sub(one, u), v), u, v, block.primitive[lane], t_min, t_max, best);
  }

  const WidePacket& packet;
  P origin, direction;
  V t_min, t_max, epsilon;
};

/// triangle_watertight.h for eight rays and one triangle.
template <>
struct Triangles<SimdTriangleTest::watertight> {
  explicit Triangles(const WidePacket& rays)
      : packet(rays), first(Vec3f(rays.direction[0][0], rays.direction[1][0], rays.direction[2][0])) {
    const D d;
    const auto k = [](int axis) { return static_cast<std::size_t>(axis); };
    const V along = hn::Load(d, rays.direction[k(first.kz)].data());
    shear_x = hn::Div(hn::Load(d, rays.direction[k(first.kx)].data()), along);
    shear_y = hn::Div(hn::Load(d, rays.direction[k(first.ky)].data()), along);
    shear_z = hn::Div(all(1), along);
    origin_x = hn::Load(d, rays.origin[k(first.kx)].data());
    origin_y = hn::Load(d, rays.origin[k(first.ky)].data());
    origin_z = hn::Load(d, rays.origin[k(first.kz)].data());
    t_min = hn::Load(d, rays.t_min.data());
    t_max = hn::Load(d, rays.t_max.data());
  }

  HWY_INLINE P sheared(const TriangleBlock<wide_block_width>& block, int corner, std::uint32_t lane) const {
    const auto& axes = block.corner[corner];
    const V x = hn::Sub(all(axes[first.kx][lane]), origin_x);
    const V y = hn::Sub(all(axes[first.ky][lane]), origin_y);
    const V z = hn::Sub(all(axes[first.kz][lane]), origin_z);
    return {hn::Sub(x, hn::Mul(shear_x, z)), hn::Sub(y, hn::Mul(shear_y, z)), z};
  }
  HWY_INLINE static V edge(const P& p, const P& q) { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); }

  HWY_INLINE void test(const TriangleBlock<wide_block_width>& block, std::uint32_t lane, Best& best) const {
    const D d;
    const V zero = hn::Zero(d);
    const P a = sheared(block, 0, lane), b = sheared(block, 1, lane), c = sheared(block, 2, lane);
    const V u = edge(c, b), v = edge(a, c), w = edge(b, a);
    const M on_edge = hn::Or(hn::Or(hn::Eq(u, zero), hn::Eq(v, zero)), hn::Eq(w, zero));
    if (HWY_UNLIKELY(!hn::AllFalse(d, on_edge))) return test_one_by_one(block, lane, best);
    const M front = hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Ge(w, zero));
    const M back = hn::And(hn::And(hn::Le(u, zero), hn::Le(v, zero)), hn::Le(w, zero));
    M inside = hn::Or(front, back);
    if (hn::AllFalse(d, inside)) return;
    const V determinant = hn::Add(hn::Add(u, v), w);
    inside = hn::And(inside, hn::Ne(determinant, zero));
    if (HWY_UNLIKELY(packet.filter != nullptr)) inside = filtered(inside, block, lane, packet);
    const V az = hn::Mul(shear_z, a.z), bz = hn::Mul(shear_z, b.z), cz = hn::Mul(shear_z, c.z);
    const V sum = hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz));
    take(inside, hn::Div(sum, determinant), hn::Div(u, determinant), hn::Div(v, determinant), hn::Div(w, determinant),
         block.primitive[lane], t_min, t_max, best);
  }

  /// Where an edge function is 0, double decides: the clear path knows how.
  HWY_NOINLINE void test_one_by_one(const TriangleBlock<wide_block_width>& block, std::uint32_t lane,
                                    Best& best) const {
    const D d;
    const TracedTriangle<float> triangle{corner(block, 0, lane), corner(block, 1, lane), corner(block, 2, lane), -1};
    HWY_ALIGN float inside[packet_width], t[packet_width], weights[3][packet_width];
    for (std::size_t i = 0; i < packet_width; ++i) {
      const Vec3f direction{packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
      const Vec3f origin{packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]};
      const auto result = triangle_watertight(origin, Shear<float>(direction), triangle, TriangleGuard::none);
      inside[i] = result.verdict == TriangleVerdict::inside ? 1.0f : 0.0f;
      t[i] = result.t;
      for (std::size_t k = 0; k < 3; ++k) weights[k][i] = result.weights[k];
    }
    M counts = hn::Gt(hn::Load(d, inside), hn::Zero(d));
    if (packet.filter != nullptr) counts = filtered(counts, block, lane, packet);
    take(counts, hn::Load(d, t), hn::Load(d, weights[0]), hn::Load(d, weights[1]), hn::Load(d, weights[2]),
         block.primitive[lane], t_min, t_max, best);
  }

  const WidePacket& packet;
  Shear<float> first;  ///< of the first ray: all share its axes
  V shear_x, shear_y, shear_z, origin_x, origin_y, origin_z, t_min, t_max;
};

/// One axis of the rays as boxes are tested; see BoxRay in wide_nodes-inl.h.
struct Axis {
  V inverse, near, far;
  std::size_t near_plane = 0, far_plane = 0;
};

HWY_INLINE Axis box_axis(const WidePacket& packet, const Vec3f& centre, std::size_t axis, V least) {
  const D d;
  const V direction = hn::Load(d, packet.direction[axis].data());
  const V origin = hn::Sub(hn::Load(d, packet.origin[axis].data()), all(centre[static_cast<int>(axis)]));
  const V sign = hn::And(direction, hn::SignBit(d));
  const V pad = hn::Or(all(1.25f * packet.pad), sign);
  Axis result;
  result.inverse = hn::Or(hn::Div(all(1), hn::Max(hn::Abs(direction), least)), sign);
  result.near = hn::Mul(hn::Add(origin, pad), result.inverse);
  result.far = hn::Mul(hn::Sub(origin, pad), result.inverse);
  const std::size_t down = std::signbit(packet.direction[axis][0]) ? 1 : 0;
  result.near_plane = 2 * axis + down;
  result.far_plane = 2 * axis + 1 - down;
  return result;
}

/// The rays of a packet as boxes are tested, seen from WideBvh::centre.
struct BoxAxes {
  BoxAxes(const WidePacket& packet, const Vec3f& centre) {
    const D d;
    const auto size = [&](std::size_t axis) { return hn::Abs(hn::Load(d, packet.direction[axis].data())); };
    const V least = hn::Mul(all(1e-20f), hn::Max(hn::Max(size(0), size(1)), size(2)));
    x = box_axis(packet, centre, 0, least);
    y = box_axis(packet, centre, 1, least);
    z = box_axis(packet, centre, 2, least);
  }
  Axis x, y, z;
};

/// Where the rays are inside a box, within [0, limit]; `plane(i)` is plane i of WideNode::planes.
struct LaneSpan {
  V first, last;
};
template <class Plane>
HWY_INLINE LaneSpan span_in_box(const BoxAxes& rays, V limit, Plane&& plane) {
  const auto& [x, y, z] = rays;
  const V in_x = hn::MulSub(plane(x.near_plane), x.inverse, x.near);
  const V in_y = hn::MulSub(plane(y.near_plane), y.inverse, y.near);
  const V in_z = hn::MulSub(plane(z.near_plane), z.inverse, z.near);
  const V out_x = hn::MulSub(plane(x.far_plane), x.inverse, x.far);
  const V out_y = hn::MulSub(plane(y.far_plane), y.inverse, y.far);
  const V out_z = hn::MulSub(plane(z.far_plane), z.inverse, z.far);
  return {hn::Max(in_z, hn::Max(in_y, hn::Max(in_x, hn::Zero(D())))),
          hn::Min(out_z, hn::Min(out_y, hn::Min(out_x, limit)))};
}

/// All rays of a packet from one point at once, against the eight boxes of a node: intervals in place of numbers.
class Beam {
 public:
  Beam(const WidePacket& packet, const Vec3f& centre, const BoxAxes& rays)
      : axes_{side(packet, centre, 0, rays.x), side(packet, centre, 1, rays.y), side(packet, centre, 2, rays.z)} {
    for (const Side& axis : axes_) one_origin_ = one_origin_ && axis.one_origin;
  }
  /// Bit i: some ray may meet box i before `limit`. The last factor makes up for the rounding of the products.
  HWY_INLINE unsigned meets(const WideNode& node, V limit) const {
    if (!one_origin_) return 0xffu;
    const D d;
    V first = hn::Zero(d), last = limit;
    for (const Side& axis : axes_) {
      const V in = hn::Sub(hn::Load(d, node.planes[axis.near_plane]), axis.entering);
      const V out = hn::Sub(hn::Load(d, node.planes[axis.far_plane]), axis.leaving);
      first = hn::Max(first, hn::Min(hn::Mul(in, axis.least), hn::Mul(in, axis.most)));
      last = hn::Min(last, hn::Max(hn::Mul(out, axis.least), hn::Mul(out, axis.most)));
    }
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Le(first, hn::Mul(last, all(1.00001f))), bytes);
    return bytes[0];
  }

 private:
  struct Side {
    V entering, leaving;  ///< the origin as seen from the planes where the rays enter and leave
    V least, most;        ///< 1 / direction
    std::size_t near_plane, far_plane;
    bool one_origin;
  };
  static Side side(const WidePacket& packet, const Vec3f& centre, std::size_t axis, const Axis& rays) {
    const D d;
    const float first = packet.origin[axis][0], origin = first - centre[static_cast<int>(axis)];
    const float grown = std::copysign(1.25f * packet.pad, packet.direction[axis][0]);
    return {all(origin + grown),
            all(origin - grown),
            hn::MinOfLanes(d, rays.inverse),
            hn::MaxOfLanes(d, rays.inverse),
            rays.near_plane,
            rays.far_plane,
            hn::AllTrue(d, hn::Eq(hn::Load(d, packet.origin[axis].data()), all(first)))};
  }
  Side axes_[3];
  bool one_origin_ = true;
};

unsigned meets(const Box<float>& box, const WidePacket& packet, const Vec3f& centre) {
  const D d;
  const Vec3f low = box.low - centre, high = box.high - centre;
  const float planes[6] = {low.x, high.x, low.y, high.y, low.z, high.z};
  const auto plane = [&](std::size_t index) HWY_ATTR { return all(planes[index]); };
  const LaneSpan span = span_in_box(BoxAxes(packet, centre), hn::Load(d, packet.t_max.data()), plane);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, hn::Le(span.first, span.last), bytes);
  return bytes[0];
}

template <SimdTriangleTest test>
void search(const WideBvh& bvh, const WidePacket& packet, WidePacketHits& hits, WideCount& count) {
  const D d;
  const I i;
  const BoxAxes rays(packet, bvh.centre);
  const Beam beam(packet, bvh.centre, rays);
  const auto octant_shift =
      3 * ((rays.x.near_plane & 1u) | (rays.y.near_plane & 1u) << 1 | (rays.z.near_plane & 1u) << 2);
  const Triangles<test> triangles(packet);
  Best best{
      hn::Load(d, hits.t.data()),
      hn::Load(i, hits.primitive.data()),
      {hn::Load(d, hits.weights[0].data()), hn::Load(d, hits.weights[1].data()), hn::Load(d, hits.weights[2].data())}};

  struct Waiting {
    HWY_ALIGN float near[packet_width];  ///< infinite where the lane passes by
    WideChild child;
  };
  std::array<Waiting, WideBvh::most_waiting + wide_width> stack;
  std::size_t top = 0;
  WideChild current = 0;
  V limit = hn::MaxOfLanes(d, best.t);
  while (true) {
    if (is_leaf(current)) {
      const TriangleBlock<wide_block_width>* const blocks = &bvh.blocks[leaf_first(current)];
      const std::uint32_t number = leaf_count(current);
      for (std::uint32_t b = 0; b < number; ++b)
        for (std::uint32_t lane = 0; lane < wide_block_width && blocks[b].primitive[lane] != no_primitive; ++lane) {
          triangles.test(blocks[b], lane, best);
          count.triangles += packet_width;
        }
      limit = hn::MaxOfLanes(d, best.t);
    } else {
      const WideNode& node = bvh.nodes[current];
      ++count.nodes;
      const unsigned perhaps = beam.meets(node, limit);
      for (int place = wide_width - 1; place >= 0; --place) {  // the nearest on top
        const std::uint32_t slot = node.order[place] >> octant_shift & 7u;
        if ((perhaps >> slot & 1u) == 0) continue;
        const auto plane = [&](std::size_t index) HWY_ATTR { return all(node.planes[index][slot]); };
        const LaneSpan span = span_in_box(rays, best.t, plane);
        const M entered = hn::Le(span.first, span.last);
        if (hn::AllFalse(d, entered)) continue;
        hn::Store(hn::IfThenElse(entered, span.first, hn::Inf(d)), d, stack[top].near);
        stack[top++].child = node.child[slot];
      }
    }
    bool found = false;
    while (top > 0 && !found) {
      --top;
      const V near = hn::Load(d, stack[top].near);
      found = !hn::AllFalse(d, hn::And(hn::Le(near, best.t), hn::Lt(near, hn::Inf(d))));
    }
    if (!found) break;
    current = stack[top].child;
  }
  hn::Store(best.t, d, hits.t.data());
  hn::Store(best.primitive, i, hits.primitive.data());
  for (std::size_t k = 0; k < 3; ++k) hn::Store(best.weights[k], d, hits.weights[k].data());
}

}  // namespace

PacketSearches packet_searches(SimdTriangleTest test) {
  switch (test) {
  case SimdTriangleTest::watertight:
    return {search<SimdTriangleTest::watertight>, meets};
  case SimdTriangleTest::moeller_trumbore:
    return {search<SimdTriangleTest::moeller_trumbore>, meets};
  }
  return {};
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

bool suits_packet(const Ray<float>* rays, std::size_t count) {
  const Shear<float> shear(rays[0].direction);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f& d = rays[i].direction;
    if (rays[i].start != no_primitive || Shear<float>(d).kz != shear.kz) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (std::signbit(d[axis]) != std::signbit(rays[0].direction[axis])) return false;
  }
  return true;
}

PacketSearches packet_searches(Simd simd, SimdTriangleTest test) {
#if HWY_ARCH_X86
  return chosen_kernel<PacketSearches>(simd, N_AVX3::packet_searches(test), N_AVX2::packet_searches(test));
#else
  static_cast<void>(simd);
  static_cast<void>(test);
  return {};
#endif
}

}  // namespace ps
#endif
