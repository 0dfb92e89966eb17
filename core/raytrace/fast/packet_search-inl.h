// Which sphere do the rays of a packet meet? Vector form of intersector.h for spheres.
#if defined(PIXELSCOPE_PACKET_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_PACKET_SEARCH_INL_H_
#undef PIXELSCOPE_PACKET_SEARCH_INL_H_
#else
#define PIXELSCOPE_PACKET_SEARCH_INL_H_
#endif

#include "hwy/highway.h"
#include "math/vec3-inl.h"
#include "raytrace/fast/packet.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

using V3 = Vec3Lanes<D>;

HWY_INLINE V splat(float value) { return hn::Set(D(), value); }
HWY_INLINE V3 splat(const Vec3f& value) { return same_in_lanes<D>(value); }
HWY_INLINE M no_lane() { return hn::Lt(hn::Zero(D()), hn::Zero(D())); }

enum class From { eye, surface };

/// One ray in each lane.
struct PacketRay {
  V3 origin, direction;
  V a;      ///< D.D
  V start;  ///< index of the sphere that the ray starts on; -1 = none
  V t_min, t_max;
  From from;
};

struct PacketHit {
  V t;
  V index;   ///< of the sphere; -1 = none
  M enters;  ///< the ray comes from outside the sphere
};

/// c of the robust sphere test: the one part that is computed in double.
HWY_INLINE V power_of_origin(const PacketRay& ray, const PacketSphere& sphere) {
  if (ray.from == From::eye) return splat(sphere.eye_c);
  const hn::Half<D> half;
  const hn::Repartition<double, D> wide;
  const double radius = static_cast<double>(sphere.radius);
  const auto part = [&](auto x, auto y, auto z) HWY_ATTR {
    const auto fx = hn::Sub(hn::PromoteTo(wide, x), hn::Set(wide, static_cast<double>(sphere.x)));
    const auto fy = hn::Sub(hn::PromoteTo(wide, y), hn::Set(wide, static_cast<double>(sphere.y)));
    const auto fz = hn::Sub(hn::PromoteTo(wide, z), hn::Set(wide, static_cast<double>(sphere.z)));
    const auto square = hn::Add(hn::Add(hn::Mul(fx, fx), hn::Mul(fy, fy)), hn::Mul(fz, fz));
    return hn::DemoteTo(half, hn::Sub(square, hn::Set(wide, radius * radius)));
  };
  const V3& o = ray.origin;
  const auto low = part(hn::LowerHalf(half, o.x), hn::LowerHalf(half, o.y), hn::LowerHalf(half, o.z));
  const auto high = part(hn::UpperHalf(half, o.x), hn::UpperHalf(half, o.y), hn::UpperHalf(half, o.z));
  return hn::Combine(D(), high, low);
}

enum class Search { nearest, any };

/// What a lane is tested against in place of an index: all spheres.
inline constexpr float every_sphere = -2;

/// Tests the lanes of `active` against all spheres in order, or, with `only`, each against that sphere alone (-1 =
/// none). With Search::any a lane stops at its first hit.
HWY_INLINE PacketHit search(const PacketScene& scene, const PacketRay& ray, M active, Search kind,
                            std::uint64_t& sphere_tests, const V* only = nullptr) {
  const D d;
  const V zero = hn::Zero(d);
  PacketHit best{ray.t_max, splat(-1), no_lane()};
  M live = active;
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    if (kind == Search::any && hn::AllFalse(d, live)) break;
    const PacketSphere& sphere = scene.spheres[k];
    if (only != nullptr) {
      const M this_one = hn::Eq(*only, splat(static_cast<float>(k)));
      live = hn::And(active, hn::Or(this_one, hn::Eq(*only, splat(every_sphere))));
      if (hn::AllFalse(d, live)) continue;
    }
    sphere_tests += hn::CountTrue(d, live);
    const V3 from_centre{hn::Sub(ray.origin.x, splat(sphere.x)), hn::Sub(ray.origin.y, splat(sphere.y)),
                         hn::Sub(ray.origin.z, splat(sphere.z))};
    const V b = hn::Neg(dot(from_centre, ray.direction));
    const V3 remainder = add(from_centre, scale(ray.direction, hn::Div(b, ray.a)));
    const V discriminant = hn::Sub(splat(sphere.radius * sphere.radius), dot(remainder, remainder));
    const V index = splat(static_cast<float>(k));
    const M own = hn::And(live, hn::Eq(ray.start, index));
    const M crossed = hn::AndNot(own, hn::And(live, hn::Ge(discriminant, zero)));
    const V other = hn::Div(hn::Mul(splat(2), b), ray.a);
    V t = hn::IfThenElse(hn::Lt(other, zero), zero, other);
    M enters = no_lane();
    if (!hn::AllFalse(d, crossed)) {
      const V c = power_of_origin(ray, sphere);
      const V root = hn::Sqrt(hn::Mul(ray.a, discriminant));
      const M behind = hn::Lt(b, zero);
      const V q = hn::Add(b, hn::IfThenElse(behind, hn::Neg(root), root));
      const V with_c = hn::Div(c, q);
      const V with_a = hn::Div(q, ray.a);
      const V near = hn::IfThenElse(behind, with_a, with_c);
      const V far = hn::IfThenElse(behind, with_c, with_a);
      enters = hn::AndNot(own, hn::Gt(near, ray.t_min));
      t = hn::IfThenElse(own, t, hn::IfThenElse(enters, near, far));
    }
    const M in_range = hn::And(hn::Gt(t, ray.t_min), hn::Lt(t, best.t));
    const M accepted = hn::And(hn::Or(own, crossed), in_range);
    best.t = hn::IfThenElse(accepted, t, best.t);
    best.index = hn::IfThenElse(accepted, index, best.index);
    best.enters = hn::Or(hn::And(accepted, enters), hn::AndNot(accepted, best.enters));
    if (kind == Search::any) live = hn::AndNot(accepted, live);
  }
  return best;
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
