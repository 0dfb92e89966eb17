// Vectors of space with one lane for each ray, fragment or triangle: the operations of math/vec.h in the same order.
#if defined(PIXELSCOPE_MATH_VEC3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_MATH_VEC3_INL_H_
#undef PIXELSCOPE_MATH_VEC3_INL_H_
#else
#define PIXELSCOPE_MATH_VEC3_INL_H_
#endif

#include "hwy/highway.h"
#include "math/unit.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// x, y and z in vectors with the tag D.
template <class D>
struct Vec3Lanes {
  hn::Vec<D> x, y, z;
};

/// The same vector in all lanes.
template <class D>
HWY_INLINE Vec3Lanes<D> same_in_lanes(const Vec3f& value) {
  const D d;
  return {hn::Set(d, value.x), hn::Set(d, value.y), hn::Set(d, value.z)};
}

template <class D>
HWY_INLINE Vec3Lanes<D> add(const Vec3Lanes<D>& a, const Vec3Lanes<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class D>
HWY_INLINE Vec3Lanes<D> subtract(const Vec3Lanes<D>& a, const Vec3Lanes<D>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
template <class D>
HWY_INLINE Vec3Lanes<D> scale(const Vec3Lanes<D>& a, hn::Vec<D> factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}
template <class D>
HWY_INLINE Vec3Lanes<D> divide(const Vec3Lanes<D>& a, hn::Vec<D> divisor) {
  return {hn::Div(a.x, divisor), hn::Div(a.y, divisor), hn::Div(a.z, divisor)};
}
template <class D>
HWY_INLINE Vec3Lanes<D> negate(const Vec3Lanes<D>& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
template <class D>
HWY_INLINE hn::Vec<D> dot(const Vec3Lanes<D>& a, const Vec3Lanes<D>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
template <class D>
HWY_INLINE Vec3Lanes<D> cross(const Vec3Lanes<D>& a, const Vec3Lanes<D>& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// A factor that brings each lane near enough to 1 to be squared: factor_for_square() of math/unit.h. Lanes whose
/// square is good, and NaN, get 1.
template <class D>
struct LaneFactors {
  hn::Vec<D> factor;
  bool all_one;
};
template <class D>
HWY_INLINE LaneFactors<D> factors_for_squares(hn::Vec<D> square) {
  const D d;
  using Squares = ExactSquares<hn::TFromD<D>>;
  const hn::Vec<D> one = hn::Set(d, 1);
  const hn::Mask<D> small = hn::Le(square, hn::Set(d, Squares::least));
  const hn::Mask<D> large = hn::Ge(square, hn::Set(d, Squares::greatest));
  if (HWY_LIKELY(hn::AllFalse(d, hn::Or(small, large)))) return {one, true};
  return {hn::IfThenElse(small, hn::Set(d, Squares::up), hn::IfThenElse(large, hn::Set(d, Squares::down), one)), false};
}

/// Vectors with their lengths. Where a square is too small or too large, both are those of a vector brought near 1.
template <class D>
struct MeasuredLanes {
  Vec3Lanes<D> vector;
  hn::Vec<D> length;
};
template <class D>
HWY_INLINE MeasuredLanes<D> measured(const Vec3Lanes<D>& a) {
  const hn::Vec<D> square = dot(a, a);
  const LaneFactors<D> factors = factors_for_squares<D>(square);
  if (HWY_LIKELY(factors.all_one)) return {a, hn::Sqrt(square)};
  const Vec3Lanes<D> near_one = scale(a, factors.factor);
  return {near_one, hn::Sqrt(dot(near_one, near_one))};
}

/// Lane by lane.
template <class D>
HWY_INLINE Vec3Lanes<D> choose(hn::Mask<D> mask, const Vec3Lanes<D>& yes, const Vec3Lanes<D>& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

// length_of(), unit_of(), unit_or_zero() and normalised() of math/unit.h.
template <class D>
HWY_INLINE hn::Vec<D> length_of(const Vec3Lanes<D>& a) {
  const hn::Vec<D> square = dot(a, a);
  const LaneFactors<D> factors = factors_for_squares<D>(square);
  if (HWY_LIKELY(factors.all_one)) return hn::Sqrt(square);
  const Vec3Lanes<D> near_one = scale(a, factors.factor);
  return hn::Div(hn::Sqrt(dot(near_one, near_one)), factors.factor);
}
template <class D>
HWY_INLINE Vec3Lanes<D> unit_of(const Vec3Lanes<D>& a) {
  const MeasuredLanes<D> of_a = measured(a);
  return divide(of_a.vector, of_a.length);
}
template <class D>
HWY_INLINE Vec3Lanes<D> unit_or_zero(const Vec3Lanes<D>& a) {
  const MeasuredLanes<D> of_a = measured(a);
  return choose(hn::Gt(of_a.length, hn::Zero(D())), divide(of_a.vector, of_a.length), a);
}
template <class D>
HWY_INLINE Vec3Lanes<D> normalised(const Vec3Lanes<D>& a) {
  const MeasuredLanes<D> of_a = measured(a);
  return scale(of_a.vector, hn::Div(hn::Set(D(), 1), of_a.length));
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
