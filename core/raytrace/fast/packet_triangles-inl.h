// All rays of a packet against one triangle, in the vector form of triangle_watertight.h and
// triangle_moeller_trumbore.h: the same operations in the same order in each lane.
#if defined(PIXELSCOPE_PACKET_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_PACKET_TRIANGLES_INL_H_
#undef PIXELSCOPE_PACKET_TRIANGLES_INL_H_
#else
#define PIXELSCOPE_PACKET_TRIANGLES_INL_H_
#endif

#include "hwy/highway.h"
#include "raytrace/clear/triangle_watertight.h"
#include "raytrace/fast/packet_boxes-inl.h"
#include "raytrace/fast/wide_packet.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE::packets {
/// A lane's best hit.
struct Best {
  V t;
  hn::Vec<I> primitive;
  V weights[3];
};

/// Takes t and weights in the lanes of `inside` that are in range and win: nearer, or as near with a lower index. False
/// if there is none.
HWY_INLINE bool take(M inside, V t, V w0, V w1, V w2, std::uint32_t primitive, V t_min, V t_max, Best& best) {
  const D d;
  const I i;
  const auto mine = hn::Set(i, static_cast<std::int32_t>(primitive));
  const M lower = hn::RebindMask(d, hn::Gt(best.primitive, mine));
  const M wins = hn::Or(hn::Lt(t, best.t), hn::And(hn::Eq(t, best.t), lower));
  const M taken = hn::And(hn::And(inside, wins), hn::And(hn::Gt(t, t_min), hn::Lt(t, t_max)));
  if (hn::AllFalse(d, taken)) return false;
  best.t = hn::IfThenElse(taken, t, best.t);
  best.primitive = hn::IfThenElse(hn::RebindMask(i, taken), mine, best.primitive);
  best.weights[0] = hn::IfThenElse(taken, w0, best.weights[0]);
  best.weights[1] = hn::IfThenElse(taken, w1, best.weights[1]);
  best.weights[2] = hn::IfThenElse(taken, w2, best.weights[2]);
  return true;
}

inline Vec3f corner(const TriangleBlock& block, int corner, std::uint32_t lane) {
  const auto& axes = block.corner[corner];
  return {axes[0][lane], axes[1][lane], axes[2][lane]};
}

/// Those of the rays in `inside` for which the triangle counts.
inline HWY_NOINLINE M filtered(M inside, const TriangleBlock& block, std::uint32_t lane, const WidePacket& packet) {
  const D d;
  unsigned bits = bits_of(d, inside);
  const TracedTriangle<float> triangle{corner(block, 0, lane), corner(block, 1, lane), corner(block, 2, lane), -1};
  for (std::size_t i = 0; i < width; ++i) {
    const Vec3f direction{packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
    const unsigned bit = 1u << i;
    if ((bits & bit) != 0 && !packet.filter->counts(direction, block.primitive[lane], triangle)) bits &= ~bit;
  }
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8)};
  return hn::LoadMaskBits(d, bytes);
}

/// Whether all rays of a packet start at one point, as eye rays in perspective do. Then much of a triangle's test is
/// the same for all of them, and is done for the triangles of a block side by side.
enum class Origins { one, many };

template <SimdTriangleTest test, Origins origins>
struct Triangles;

using OfBlock = hn::CappedTag<float, block_width>;
using PointsOfBlock = Vec3Lanes<OfBlock>;

/// The places that hold triangles, bit i meaning place i.
HWY_INLINE unsigned filled(const TriangleBlock& block) {
  const hn::Rebind<std::uint32_t, OfBlock> d;
  return bits_of(d, hn::Ne(hn::Load(d, block.primitive), hn::Set(d, no_primitive)));
}

/// Those places of a block whose triangle a ray of the beam may meet before `limit`: by the triangles' boxes, which
/// have the pad of a leaf's. A packet is narrow beside a leaf of eight triangles, and passes most of them by.
HWY_INLINE unsigned perhaps_met(const TriangleBlock& block, const Beam& beam, const Vec3f& centre, float limit) {
  const OfBlock d;
  HWY_ALIGN float planes[6][block_width];
  for (int axis = 0; axis < 3; ++axis) {
    const auto corner = [&](int i) HWY_ATTR { return hn::Load(d, block.corner[i][axis]); };
    const auto a = corner(0), b = corner(1), c = corner(2), middle = hn::Set(d, centre[axis]);
    hn::Store(hn::Sub(hn::Min(hn::Min(a, b), c), middle), d, planes[2 * axis]);
    hn::Store(hn::Sub(hn::Max(hn::Max(a, b), c), middle), d, planes[2 * axis + 1]);
  }
  return filled(block) & beam.meets(planes, limit);
}

HWY_INLINE PointsOfBlock corners(const TriangleBlock& block, int corner) {
  const OfBlock d;
  const auto& axes = block.corner[corner];
  return {hn::Load(d, axes[0]), hn::Load(d, axes[1]), hn::Load(d, axes[2])};
}

/// A vector for each triangle of a block, to be read for all rays.
struct alignas(32) EachTriangle {
  float x[block_width], y[block_width], z[block_width];
  HWY_INLINE void set(const PointsOfBlock& points) {
    const OfBlock d;
    hn::Store(points.x, d, x);
    hn::Store(points.y, d, y);
    hn::Store(points.z, d, z);
  }
  HWY_INLINE P of(std::uint32_t lane) const { return {all(x[lane]), all(y[lane]), all(z[lane])}; }
};

/// triangle_moeller_trumbore.h for all rays and one triangle.
template <Origins origins>
struct Triangles<SimdTriangleTest::moeller_trumbore, origins> {
  explicit Triangles(const WidePacket& rays) : packet(rays), epsilon(all(rays.triangle_epsilon)) {
    const D d;
    origin = {hn::Load(d, packet.origin[0].data()), hn::Load(d, packet.origin[1].data()),
              hn::Load(d, packet.origin[2].data())};
    direction = {hn::Load(d, packet.direction[0].data()), hn::Load(d, packet.direction[1].data()),
                 hn::Load(d, packet.direction[2].data())};
    t_min = hn::Load(d, packet.t_min.data());
    t_max = hn::Load(d, packet.t_max.data());
  }

  /// What does not depend on the ray.
  struct Shared {
    EachTriangle a, edge_b, edge_c, s, q;
    HWY_ALIGN float t_part[block_width];
  };
  HWY_INLINE void share(const TriangleBlock& block, Shared& shared) const {
    const PointsOfBlock a = corners(block, 0);
    const PointsOfBlock edge_b = subtract(corners(block, 1), a), edge_c = subtract(corners(block, 2), a);
    shared.edge_b.set(edge_b);
    shared.edge_c.set(edge_c);
    if (origins == Origins::many) return shared.a.set(a);
    const PointsOfBlock s =
        subtract(same_in_lanes<OfBlock>({packet.origin[0][0], packet.origin[1][0], packet.origin[2][0]}), a);
    const PointsOfBlock q = cross(s, edge_b);
    shared.s.set(s);
    shared.q.set(q);
    hn::Store(dot(edge_c, q), OfBlock(), shared.t_part);
  }

  /// Says whether a ray's best has changed.
  HWY_INLINE bool test(const TriangleBlock& block, const Shared& shared, std::uint32_t lane, Best& best) const {
    const D d;
    const V zero = hn::Zero(d), one = all(1);
    const P edge_b = shared.edge_b.of(lane), edge_c = shared.edge_c.of(lane);
    const P p = cross(direction, edge_c);
    const V determinant = dot(edge_b, p);
    const P s = origins == Origins::one ? shared.s.of(lane) : subtract(origin, shared.a.of(lane));
    const P q = origins == Origins::one ? shared.q.of(lane) : cross(s, edge_b);
    const V t_part = origins == Origins::one ? all(shared.t_part[lane]) : dot(edge_c, q);
    const V u_part = dot(s, p), v_part = dot(direction, q);
    // Most rays can be rejected before the divisions. The decision falls after them.
    const V sign = hn::And(determinant, hn::SignBit(d));
    const V size = hn::Xor(determinant, sign), slack = hn::Mul(size, all(1e-6f));
    const V u_size = hn::Xor(u_part, sign), v_size = hn::Xor(v_part, sign), t_size = hn::Xor(t_part, sign);
    const V rest = hn::Sub(hn::Sub(size, u_size), v_size);
    const V farthest = hn::MulAdd(size, hn::Mul(best.t, all(1.000001f)), all(1e-37f));
    const M perhaps =
        hn::And(hn::Ge(hn::Add(hn::Min(hn::Min(u_size, v_size), rest), slack), zero), hn::Le(t_size, farthest));
    if (hn::AllFalse(d, perhaps)) return false;
    const V u = hn::Div(u_part, determinant), v = hn::Div(v_part, determinant), t = hn::Div(t_part, determinant);
    const M positive = hn::And(hn::Ge(u, zero), hn::Ge(v, zero));
    M inside = hn::And(hn::And(hn::Gt(size, epsilon), positive), hn::Le(hn::Add(u, v), one));
    if (HWY_UNLIKELY(packet.filter != nullptr)) inside = filtered(inside, block, lane, packet);
    return take(inside, t, hn::Sub(hn::Sub(one, u), v), u, v, block.primitive[lane], t_min, t_max, best);
  }

  const WidePacket& packet;
  P origin, direction;
  V t_min, t_max, epsilon;
};

/// triangle_watertight.h for all rays and one triangle.
template <Origins origins>
struct Triangles<SimdTriangleTest::watertight, origins> {
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

  /// The corners, seen from the origin if there is one.
  struct Shared {
    EachTriangle corner[3];
  };
  HWY_INLINE void share(const TriangleBlock& block, Shared& shared) const {
    const PointsOfBlock origin =
        same_in_lanes<OfBlock>({packet.origin[0][0], packet.origin[1][0], packet.origin[2][0]});
    for (int i = 0; i < 3; ++i)
      shared.corner[i].set(origins == Origins::one ? subtract(corners(block, i), origin) : corners(block, i));
  }

  HWY_INLINE P sheared(const Shared& shared, int corner, std::uint32_t lane) const {
    const float* const numbers = shared.corner[corner].x + lane;
    const auto along = [&](int axis) HWY_ATTR { return all(numbers[axis * block_width]); };
    const bool one = origins == Origins::one;
    const V x = one ? along(first.kx) : hn::Sub(along(first.kx), origin_x);
    const V y = one ? along(first.ky) : hn::Sub(along(first.ky), origin_y);
    const V z = one ? along(first.kz) : hn::Sub(along(first.kz), origin_z);
    return {hn::Sub(x, hn::Mul(shear_x, z)), hn::Sub(y, hn::Mul(shear_y, z)), z};
  }
  HWY_INLINE static V edge(const P& p, const P& q) { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); }

  /// Says whether a ray's best has changed.
  HWY_INLINE bool test(const TriangleBlock& block, const Shared& shared, std::uint32_t lane, Best& best) const {
    const D d;
    const V zero = hn::Zero(d);
    const P a = sheared(shared, 0, lane), b = sheared(shared, 1, lane), c = sheared(shared, 2, lane);
    const V u = edge(c, b), v = edge(a, c), w = edge(b, a);
    const M on_edge = hn::Or(hn::Or(hn::Eq(u, zero), hn::Eq(v, zero)), hn::Eq(w, zero));
    if (HWY_UNLIKELY(!hn::AllFalse(d, on_edge))) return test_one_by_one(block, lane, best);
    const M front = hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Ge(w, zero));
    const M back = hn::And(hn::And(hn::Le(u, zero), hn::Le(v, zero)), hn::Le(w, zero));
    M inside = hn::Or(front, back);
    if (hn::AllFalse(d, inside)) return false;
    const V determinant = hn::Add(hn::Add(u, v), w);
    inside = hn::And(inside, hn::Ne(determinant, zero));
    if (HWY_UNLIKELY(packet.filter != nullptr)) inside = filtered(inside, block, lane, packet);
    const V az = hn::Mul(shear_z, a.z), bz = hn::Mul(shear_z, b.z), cz = hn::Mul(shear_z, c.z);
    const V sum = hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz));
    return take(inside, hn::Div(sum, determinant), hn::Div(u, determinant), hn::Div(v, determinant),
                hn::Div(w, determinant), block.primitive[lane], t_min, t_max, best);
  }

  /// Where an edge function is 0, double decides: the clear path knows how.
  HWY_NOINLINE bool test_one_by_one(const TriangleBlock& block, std::uint32_t lane, Best& best) const {
    const D d;
    const TracedTriangle<float> triangle{corner(block, 0, lane), corner(block, 1, lane), corner(block, 2, lane), -1};
    HWY_ALIGN float inside[width], t[width], weights[3][width];
    for (std::size_t i = 0; i < width; ++i) {
      const Vec3f direction{packet.direction[0][i], packet.direction[1][i], packet.direction[2][i]};
      const Vec3f origin{packet.origin[0][i], packet.origin[1][i], packet.origin[2][i]};
      const auto result = triangle_watertight(origin, Shear<float>(direction), triangle, TriangleGuard::none);
      inside[i] = result.verdict == TriangleVerdict::inside ? 1.0f : 0.0f;
      t[i] = result.t;
      for (std::size_t k = 0; k < 3; ++k) weights[k][i] = result.weights[k];
    }
    M counts = hn::Gt(hn::Load(d, inside), hn::Zero(d));
    if (packet.filter != nullptr) counts = filtered(counts, block, lane, packet);
    return take(counts, hn::Load(d, t), hn::Load(d, weights[0]), hn::Load(d, weights[1]), hn::Load(d, weights[2]),
                block.primitive[lane], t_min, t_max, best);
  }

  const WidePacket& packet;
  Shear<float> first;  ///< of the first ray: all share its axes
  V shear_x, shear_y, shear_z, origin_x, origin_y, origin_z, t_min, t_max;
};

}  // namespace ps::HWY_NAMESPACE::packets
HWY_AFTER_NAMESPACE();

#endif
