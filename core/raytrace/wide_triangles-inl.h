// One ray against the four triangles of a block, in the vector form of triangle_watertight.h and
// triangle_moeller_trumbore.h: the same operations in the same order in each lane.
#if defined(PIXELSCOPE_WIDE_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#undef PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#else
#define PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#endif

#include "hwy/highway.h"
#include "raytrace/triangle_watertight.h"
#include "raytrace/wide_search.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using B = hn::CappedTag<float, wide_block_width>;
using Four = hn::Vec<B>;
using Mask4 = hn::Mask<B>;
struct Point4 {
  Four x, y, z;
};

HWY_INLINE Four all4(float value) { return hn::Set(B(), value); }
HWY_INLINE Point4 corner4(const TriangleBlock& block, int corner) {
  const B d;
  return {hn::Load(d, block.corner[corner][0]), hn::Load(d, block.corner[corner][1]),
          hn::Load(d, block.corner[corner][2])};
}
HWY_INLINE Point4 subtract4(const Point4& a, const Point4& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Four dot4(const Point4& a, const Point4& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Point4 cross4(const Point4& a, const Point4& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE unsigned bits4(Mask4 mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(B(), mask, bits);
  return bits[0];
}

/// Lanes whose t is in the ray's range and not beyond what is known: Intersector::judge() but for ties.
HWY_INLINE Mask4 in_range4(Four t, const Ray<float>& ray, const Hit<float>& best) {
  return hn::And(hn::And(hn::Gt(t, all4(ray.t_min)), hn::Lt(t, all4(ray.t_max))), hn::Le(t, all4(best.t)));
}

/// Of the lanes in `bits`, takes those that win: nearer, or as near with a lower index. `weights(lane)` and
/// `confirmed(lane)` are called for lanes that would win.
template <class Weights, class Confirmed>
HWY_INLINE bool take_best4(const TriangleBlock& block, unsigned bits, const float* t, const WideQuery& query,
                           Hit<float>& best, Weights&& weights, Confirmed&& confirmed) {
  bool taken = false;
  for (; bits != 0; bits &= bits - 1) {
    const int lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
    const std::uint32_t primitive = block.primitive[lane];
    if (primitive == query.ray.start || t[lane] > best.t) continue;
    if (t[lane] == best.t && best.found() && primitive > best.primitive) continue;
    if (!confirmed(lane)) continue;
    best = {primitive, t[lane], weights(lane)};
    taken = true;
  }
  return taken;
}

template <TriangleTest test>
struct BlockRay;

template <>
struct BlockRay<TriangleTest::moeller_trumbore> {
  explicit BlockRay(const WideQuery& query)
      : origin{all4(query.ray.origin.x), all4(query.ray.origin.y), all4(query.ray.origin.z)},
        direction{all4(query.ray.direction.x), all4(query.ray.direction.y), all4(query.ray.direction.z)} {}

  HWY_INLINE bool test(const TriangleBlock& block, const WideQuery& query, Hit<float>& best) const {
    const B d;
    const Four zero = hn::Zero(d);
    const Point4 a = corner4(block, 0);
    const Point4 edge_b = subtract4(corner4(block, 1), a);
    const Point4 edge_c = subtract4(corner4(block, 2), a);
    const Point4 p = cross4(direction, edge_c);
    const Four determinant = dot4(edge_b, p);
    const Point4 s = subtract4(origin, a);
    const Point4 q = cross4(s, edge_b);
    const Four u_part = dot4(s, p), v_part = dot4(direction, q), t_part = dot4(edge_c, q);
    // Most lanes can be told to miss before the divisions. The decision falls after them.
    const Four sign = hn::And(determinant, hn::SignBit(d));
    const Four size = hn::Xor(determinant, sign), slack = hn::Mul(size, all4(1e-6f));
    const Four u_size = hn::Xor(u_part, sign), v_size = hn::Xor(v_part, sign), t_size = hn::Xor(t_part, sign);
    const Four rest = hn::Sub(hn::Sub(size, u_size), v_size);
    const Mask4 perhaps =
        hn::And(hn::Ge(hn::Add(hn::Min(hn::Min(u_size, v_size), rest), slack), zero),
                hn::And(hn::Ge(t_size, zero), hn::Le(t_size, hn::Mul(size, all4(best.t * 1.000001f)))));
    if (hn::AllFalse(d, perhaps)) return false;
    const Four u = hn::Div(u_part, determinant);
    const Four v = hn::Div(v_part, determinant);
    const Mask4 sure = hn::Gt(size, all4(query.triangle_epsilon));
    const Mask4 positive = hn::And(hn::Ge(u, zero), hn::Ge(v, zero));
    const Mask4 inside = hn::And(hn::And(sure, positive), hn::Le(hn::Add(u, v), all4(1)));
    const Four t = hn::Div(t_part, determinant);
    const unsigned bits = bits4(hn::And(inside, in_range4(t, query.ray, best)));
    if (bits == 0) return false;
    HWY_ALIGN float ts[4], us[4], vs[4];
    hn::Store(t, d, ts);
    hn::Store(u, d, us);
    hn::Store(v, d, vs);
    const auto weights = [&](int i) { return std::array<float, 3>{1.0f - us[i] - vs[i], us[i], vs[i]}; };
    return take_best4(block, bits, ts, query, best, weights, [](int) { return true; });
  }

  Point4 origin, direction;
};

template <>
struct BlockRay<TriangleTest::watertight> {
  explicit BlockRay(const WideQuery& query) : shear(query.ray.direction) {
    for (int axis = 0; axis < 3; ++axis) origin[axis] = query.ray.origin[axis];
  }

  struct Sheared {
    Four x, y, far;  ///< far: along the ray, before the scale
  };
  HWY_INLINE Sheared sheared(const TriangleBlock& block, int corner) const {
    const B d;
    const Four x = hn::Sub(hn::Load(d, block.corner[corner][shear.kx]), all4(origin[shear.kx]));
    const Four y = hn::Sub(hn::Load(d, block.corner[corner][shear.ky]), all4(origin[shear.ky]));
    const Four z = hn::Sub(hn::Load(d, block.corner[corner][shear.kz]), all4(origin[shear.kz]));
    return {hn::Sub(x, hn::Mul(all4(shear.x), z)), hn::Sub(y, hn::Mul(all4(shear.y), z)), z};
  }
  HWY_INLINE static Four edge(const Sheared& p, const Sheared& q) {
    return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x));
  }

  /// Where an edge function of a lane is 0, all three of that lane come from double.
  HWY_NOINLINE static void decide_in_double(unsigned lanes, const Sheared& a, const Sheared& b, const Sheared& c,
                                            Four& u, Four& v, Four& w) {
    const B d;
    HWY_ALIGN float numbers[6][4], edges[3][4];
    const Four sources[6] = {a.x, a.y, b.x, b.y, c.x, c.y};
    for (int i = 0; i < 6; ++i) hn::Store(sources[i], d, numbers[i]);
    hn::Store(u, d, edges[0]);
    hn::Store(v, d, edges[1]);
    hn::Store(w, d, edges[2]);
    for (; lanes != 0; lanes &= lanes - 1) {
      const int i = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
      const auto difference = [&](int p, int q, int r, int s) {
        return static_cast<float>(static_cast<double>(numbers[p][i]) * static_cast<double>(numbers[q][i]) -
                                  static_cast<double>(numbers[r][i]) * static_cast<double>(numbers[s][i]));
      };
      edges[0][i] = difference(4, 3, 5, 2);
      edges[1][i] = difference(0, 5, 1, 4);
      edges[2][i] = difference(2, 1, 3, 0);
    }
    u = hn::Load(d, edges[0]);
    v = hn::Load(d, edges[1]);
    w = hn::Load(d, edges[2]);
  }

  HWY_INLINE bool test(const TriangleBlock& block, const WideQuery& query, Hit<float>& best) const {
    const B d;
    const Four zero = hn::Zero(d);
    const Sheared a = sheared(block, 0), b = sheared(block, 1), c = sheared(block, 2);
    Four u = edge(c, b), v = edge(a, c), w = edge(b, a);
    const Mask4 on_edge = hn::Or(hn::Or(hn::Eq(u, zero), hn::Eq(v, zero)), hn::Eq(w, zero));
    if (HWY_UNLIKELY(!hn::AllFalse(d, on_edge))) decide_in_double(bits4(on_edge), a, b, c, u, v, w);
    const Mask4 front = hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Ge(w, zero));
    const Mask4 back = hn::And(hn::And(hn::Le(u, zero), hn::Le(v, zero)), hn::Le(w, zero));
    const Mask4 inside = hn::Or(front, back);
    if (hn::AllFalse(d, inside)) return false;
    const Four determinant = hn::Add(hn::Add(u, v), w);
    const Four scale = all4(shear.z);
    const Four az = hn::Mul(scale, a.far), bz = hn::Mul(scale, b.far), cz = hn::Mul(scale, c.far);
    const Four sum = hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz));
    const Four t = hn::Div(sum, determinant);
    const Mask4 sure = hn::Ne(determinant, zero);
    const unsigned bits = bits4(hn::And(hn::And(inside, sure), in_range4(t, query.ray, best)));
    if (bits == 0) return false;
    HWY_ALIGN float ts[4], us[4], vs[4], ws[4], sums[4];
    hn::Store(t, d, ts);
    hn::Store(u, d, us);
    hn::Store(v, d, vs);
    hn::Store(w, d, ws);
    hn::Store(determinant, d, sums);
    const auto weights = [&](int i) { return std::array<float, 3>{us[i] / sums[i], vs[i] / sums[i], ws[i] / sums[i]}; };
    const auto confirmed = [&](int i) { return query.ray.start == no_primitive || unguarded(block, query, i); };
    return take_best4(block, bits, ts, query, best, weights, confirmed);
  }

  /// For the few candidates of rays that leave a surface: is t beyond its own rounding error? The clear path knows.
  HWY_NOINLINE bool unguarded(const TriangleBlock& block, const WideQuery& query, int lane) const {
    TracedTriangle<float> triangle;
    for (int axis = 0; axis < 3; ++axis) {
      triangle.a[axis] = block.corner[0][axis][lane];
      triangle.b[axis] = block.corner[1][axis][lane];
      triangle.c[axis] = block.corner[2][axis][lane];
    }
    return triangle_watertight(query.ray.origin, shear, triangle, TriangleGuard::rounding_of_t).verdict ==
           TriangleVerdict::inside;
  }

  Shear<float> shear;
  std::array<float, 3> origin;
};

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
