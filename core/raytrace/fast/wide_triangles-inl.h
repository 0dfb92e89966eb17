// One ray against the triangles of a block, in the vector form of triangle_watertight.h and
// triangle_moeller_trumbore.h: the same operations in the same order in each lane.
#if defined(PIXELSCOPE_WIDE_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#undef PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#else
#define PIXELSCOPE_WIDE_TRIANGLES_INL_H_
#endif

#include "hwy/highway.h"
#include "math/vec3-inl.h"
#include "raytrace/clear/triangle_watertight.h"
#include "raytrace/fast/wide_search.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Vectors for blocks of triangles. Where a register holds fewer, a block is tested in parts.
struct Block {
  using D = hn::CappedTag<float, block_width>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  static constexpr int lanes = HWY_TARGET == HWY_SSE4 ? 4 : block_width;
  using Point = Vec3Lanes<D>;

  static HWY_INLINE V all(float value) { return hn::Set(D(), value); }
  static HWY_INLINE Point corner(const TriangleBlock& block, int corner, int lane) {
    const D d;
    const auto& axes = block.corner[corner];
    return {hn::Load(d, axes[0] + lane), hn::Load(d, axes[1] + lane), hn::Load(d, axes[2] + lane)};
  }
  static HWY_INLINE unsigned bits(M mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    return bytes[0];
  }

  /// Lanes whose t is in the ray's range and not beyond what is known: Intersector::judge() but for ties.
  static HWY_INLINE M in_range(V t, const Ray<float>& ray, const Hit<float>& best) {
    return hn::And(hn::And(hn::Gt(t, all(ray.t_min)), hn::Lt(t, all(ray.t_max))), hn::Le(t, all(best.t)));
  }
};

HWY_INLINE TracedTriangle<float> triangle_in(const TriangleBlock& block, int lane) {
  TracedTriangle<float> triangle;
  for (int axis = 0; axis < 3; ++axis) {
    triangle.a[axis] = block.corner[0][axis][lane];
    triangle.b[axis] = block.corner[1][axis][lane];
    triangle.c[axis] = block.corner[2][axis][lane];
  }
  return triangle;
}
/// Whether a test asks WideQuery::filter. Code in which it never does keeps more numbers in registers.
enum class Filtered { no, yes };
HWY_NOINLINE inline bool asks_filter(const TriangleBlock& block, const WideQuery& query, int lane) {
  return query.filter->counts(query.ray.direction, block.primitive[lane], triangle_in(block, lane));
}

template <Filtered filtered>
HWY_INLINE bool passes_filter(const TriangleBlock& block, const WideQuery& query, int lane) {
  return filtered == Filtered::no || query.filter == nullptr || asks_filter(block, query, lane);
}

/// Of the lanes in `bits`, takes those that win: nearer, or as near with a lower index. `primitives` and `t` begin at
/// lane 0; `weights(lane)` and `confirmed(lane)` are called for lanes that would win.
template <class Weights, class Confirmed>
HWY_INLINE bool take_best(const std::uint32_t* primitives, unsigned bits, const float* t, const WideQuery& query,
                          Hit<float>& best, Weights&& weights, Confirmed&& confirmed) {
  bool taken = false;
  for (; bits != 0; bits &= bits - 1) {
    const int lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
    const std::uint32_t primitive = primitives[lane];
    if (primitive == query.ray.start || t[lane] > best.t) continue;
    if (t[lane] == best.t && best.found() && primitive > best.primitive) continue;
    if (!confirmed(lane)) continue;
    best = {primitive, t[lane], weights(lane)};
    taken = true;
  }
  return taken;
}

template <SimdTriangleTest test>
struct BlockRay;

template <>
struct BlockRay<SimdTriangleTest::moeller_trumbore> {
  using My = Block;
  using D = My::D;
  using V = My::V;
  using M = My::M;
  using Point = My::Point;
  explicit BlockRay(const WideQuery& query)
      : origin{My::all(query.ray.origin.x), My::all(query.ray.origin.y), My::all(query.ray.origin.z)},
        direction{My::all(query.ray.direction.x), My::all(query.ray.direction.y), My::all(query.ray.direction.z)} {}

  template <Filtered filtered = Filtered::yes>
  HWY_INLINE bool test(const TriangleBlock& block, int from, const WideQuery& query, Hit<float>& best) const {
    const D d;
    const V zero = hn::Zero(d);
    const Point a = My::corner(block, 0, from);
    const Point edge_b = subtract(My::corner(block, 1, from), a);
    const Point edge_c = subtract(My::corner(block, 2, from), a);
    const Point p = cross(direction, edge_c);
    const V determinant = dot(edge_b, p);
    const Point s = subtract(origin, a);
    const Point q = cross(s, edge_b);
    const V u_part = dot(s, p), v_part = dot(direction, q), t_part = dot(edge_c, q);
    // Most lanes can be rejected before the divisions. The decision falls after them.
    const V sign = hn::And(determinant, hn::SignBit(d));
    const V size = hn::Xor(determinant, sign), slack = hn::Mul(size, My::all(1e-6f));
    const V u_size = hn::Xor(u_part, sign), v_size = hn::Xor(v_part, sign), t_size = hn::Xor(t_part, sign);
    const V rest = hn::Sub(hn::Sub(size, u_size), v_size);
    const M perhaps =
        hn::And(hn::Ge(hn::Add(hn::Min(hn::Min(u_size, v_size), rest), slack), zero),
                hn::And(hn::Ge(t_size, zero),
                        hn::Le(t_size, hn::Add(hn::Mul(size, My::all(best.t * 1.000001f)), My::all(1e-37f)))));
    if (hn::AllFalse(d, perhaps)) return false;
    const V u = hn::Div(u_part, determinant);
    const V v = hn::Div(v_part, determinant);
    const M sure = hn::Gt(size, My::all(query.triangle_epsilon));
    const M positive = hn::And(hn::Ge(u, zero), hn::Ge(v, zero));
    const M inside = hn::And(hn::And(sure, positive), hn::Le(hn::Add(u, v), My::all(1)));
    const V t = hn::Div(t_part, determinant);
    const unsigned bits = My::bits(hn::And(inside, My::in_range(t, query.ray, best)));
    if (bits == 0) return false;
    HWY_ALIGN float ts[block_width], us[block_width], vs[block_width];
    hn::Store(t, d, ts);
    hn::Store(u, d, us);
    hn::Store(v, d, vs);
    const auto weights = [&](int i) { return std::array<float, 3>{1.0f - us[i] - vs[i], us[i], vs[i]}; };
    const auto confirmed = [&](int i) { return passes_filter<filtered>(block, query, from + i); };
    return take_best(block.primitive + from, bits, ts, query, best, weights, confirmed);
  }

  /// This test has no shorter form.
  HWY_INLINE static bool passes_all(const TriangleBlock&, int) { return false; }

  Point origin, direction;
};

template <>
struct BlockRay<SimdTriangleTest::watertight> {
  using My = Block;
  using D = My::D;
  using V = My::V;
  using M = My::M;
  explicit BlockRay(const WideQuery& query) : shear(query.ray.direction) {
    for (int axis = 0; axis < 3; ++axis) origin[axis] = query.ray.origin[axis];
  }

  struct Sheared {
    V x, y, far;  ///< far: along the ray, before the scale
  };
  HWY_INLINE Sheared sheared(const TriangleBlock& block, int corner, int from) const {
    const D d;
    const V x = hn::Sub(hn::Load(d, block.corner[corner][shear.kx] + from), My::all(origin[shear.kx]));
    const V y = hn::Sub(hn::Load(d, block.corner[corner][shear.ky] + from), My::all(origin[shear.ky]));
    const V z = hn::Sub(hn::Load(d, block.corner[corner][shear.kz] + from), My::all(origin[shear.kz]));
    return {hn::Sub(x, hn::Mul(My::all(shear.x), z)), hn::Sub(y, hn::Mul(My::all(shear.y), z)), z};
  }
  HWY_INLINE static V edge(const Sheared& p, const Sheared& q) { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); }

  /// Where an edge function of a lane is 0, all three of that lane come from double.
  HWY_NOINLINE static void decide_in_double(unsigned lanes, const Sheared& a, const Sheared& b, const Sheared& c, V& u,
                                            V& v, V& w) {
    const D d;
    HWY_ALIGN float numbers[6][block_width], edges[3][block_width];
    const V sources[6] = {a.x, a.y, b.x, b.y, c.x, c.y};
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

  /// Do all triangles lie on one side of the ray, as seen along the axis kx? Then no test would accept any: with the
  /// signs of its own numbers u * ax + v * bx + w * cx = 0, so u, v and w cannot have one sign unless all are 0. (Their
  /// signs are exact, but for underflow, which leaves no area.)
  HWY_INLINE bool passes_all(const TriangleBlock& block, int from) const {
    const D d;
    const V zero = hn::Zero(d), origin_x = My::all(origin[shear.kx]), origin_z = My::all(origin[shear.kz]);
    const V shear_x = My::all(shear.x);
    const auto across = [&](int corner) HWY_ATTR {
      const V x = hn::Sub(hn::Load(d, block.corner[corner][shear.kx] + from), origin_x);
      const V z = hn::Sub(hn::Load(d, block.corner[corner][shear.kz] + from), origin_z);
      return hn::Sub(x, hn::Mul(shear_x, z));
    };
    const V a = across(0), b = across(1), c = across(2);
    const M right = hn::Gt(hn::Min(hn::Min(a, b), c), zero), left = hn::Lt(hn::Max(hn::Max(a, b), c), zero);
    return hn::AllTrue(d, hn::Or(right, left));
  }

  template <Filtered filtered = Filtered::yes>
  HWY_INLINE bool test(const TriangleBlock& block, int from, const WideQuery& query, Hit<float>& best) const {
    const D d;
    const V zero = hn::Zero(d);
    const Sheared a = sheared(block, 0, from), b = sheared(block, 1, from), c = sheared(block, 2, from);
    V u = edge(c, b), v = edge(a, c), w = edge(b, a);
    const M on_edge = hn::Or(hn::Or(hn::Eq(u, zero), hn::Eq(v, zero)), hn::Eq(w, zero));
    if (HWY_UNLIKELY(!hn::AllFalse(d, on_edge))) decide_in_double(My::bits(on_edge), a, b, c, u, v, w);
    const M front = hn::And(hn::And(hn::Ge(u, zero), hn::Ge(v, zero)), hn::Ge(w, zero));
    const M back = hn::And(hn::And(hn::Le(u, zero), hn::Le(v, zero)), hn::Le(w, zero));
    const M inside = hn::Or(front, back);
    if (hn::AllFalse(d, inside)) return false;
    const V determinant = hn::Add(hn::Add(u, v), w);
    const V scale = My::all(shear.z);
    const V az = hn::Mul(scale, a.far), bz = hn::Mul(scale, b.far), cz = hn::Mul(scale, c.far);
    const V sum = hn::Add(hn::Add(hn::Mul(u, az), hn::Mul(v, bz)), hn::Mul(w, cz));
    const V t = hn::Div(sum, determinant);
    const M sure = hn::Ne(determinant, zero);
    const unsigned bits = My::bits(hn::And(hn::And(inside, sure), My::in_range(t, query.ray, best)));
    if (bits == 0) return false;
    HWY_ALIGN float ts[block_width], us[block_width], vs[block_width], ws[block_width], sums[block_width];
    hn::Store(t, d, ts);
    hn::Store(u, d, us);
    hn::Store(v, d, vs);
    hn::Store(w, d, ws);
    hn::Store(determinant, d, sums);
    const auto weights = [&](int i) { return std::array<float, 3>{us[i] / sums[i], vs[i] / sums[i], ws[i] / sums[i]}; };
    const auto confirmed = [&](int i) {
      return (query.ray.start == no_primitive || unguarded(block, query, from + i)) &&
             passes_filter<filtered>(block, query, from + i);
    };
    return take_best(block.primitive + from, bits, ts, query, best, weights, confirmed);
  }

  /// For the few candidates of rays that leave a surface: is t beyond its own rounding error? The clear path knows.
  HWY_NOINLINE bool unguarded(const TriangleBlock& block, const WideQuery& query, int lane) const {
    return triangle_watertight(query.ray.origin, shear, triangle_in(block, lane), TriangleGuard::rounding_of_t)
               .verdict == TriangleVerdict::inside;
  }

  Shear<float> shear;
  std::array<float, 3> origin;
};

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
