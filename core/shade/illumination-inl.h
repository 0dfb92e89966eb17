// The lights of shade/illumination.h for a vector of points, compiled once for each SIMD target (Highway). Same
// operations in the same order for each lane, so the same bits.
#if defined(PIXELSCOPE_ILLUMINATION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_ILLUMINATION_INL_H_
#undef PIXELSCOPE_ILLUMINATION_INL_H_
#else
#define PIXELSCOPE_ILLUMINATION_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "math/power-inl.h"
#include "math/vec3-inl.h"
#include "options/settings.h"
#include "shade/shading_inputs.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Points to be lit, one in each lane (LitPoint), with what their materials say of highlights.
template <class D>
struct LitLanes {
  Vec3Lanes<D> position, normal, to_eye;
  hn::Vec<D> normal_length;
  hn::Mask<D> specular;  ///< the material shines and highlights are on
  hn::Vec<D> exponent;   ///< finite and above 0
  hn::Vec<D> faint;      ///< faint_cosine() of it, or less
  Highlight highlight = Highlight::phong;
};

/// sum + colour * amount in the lanes of `mask`.
template <class D>
HWY_INLINE void add_light(Vec3Lanes<D>& sum, hn::Mask<D> mask, const Vec3f& colour, hn::Vec<D> amount) {
  const D d;
  const Vec3Lanes<D> more{hn::Add(sum.x, hn::Mul(hn::Set(d, colour.x), amount)),
                          hn::Add(sum.y, hn::Mul(hn::Set(d, colour.y), amount)),
                          hn::Add(sum.z, hn::Mul(hn::Set(d, colour.z), amount))};
  sum = choose(mask, more, sum);
}

/// The two directions of highlight_angle().
template <class D>
struct HighlightLanes {
  Vec3Lanes<D> a, b;
};
template <class D>
HWY_INLINE HighlightLanes<D> highlight_lanes(const LitLanes<D>& points, const Vec3Lanes<D>& to_light,
                                             hn::Vec<D> n_dot_l) {
  HighlightLanes<D> angle{points.normal, points.to_eye};
  switch (points.highlight) {
  case Highlight::phong:
    angle.a = subtract(scale(points.normal, hn::Mul(hn::Set(D(), 2.0f), n_dot_l)), to_light);
    break;
  case Highlight::blinn_phong:
    angle.b = add(unit_of(to_light), unit_of(angle.b));
    break;
  }
  return angle;
}

/// adds_light() for such a light.
template <class D>
HWY_INLINE hn::Mask<D> adds_light(const LitLanes<D>& points, const Vec3Lanes<D>& to_light) {
  const hn::Vec<D> zero = hn::Zero(D());
  const hn::Vec<D> n_dot_l = dot(points.normal, to_light);
  const HighlightLanes<D> angle = highlight_lanes(points, to_light, n_dot_l);
  return hn::Or(hn::Gt(n_dot_l, zero), hn::And(points.specular, hn::Gt(dot(angle.a, angle.b), zero)));
}

/// The light that a point or directional light without attenuation adds in the lanes of `lit`: diffuse, then its
/// highlight, by the equation of the book.
template <class D>
HWY_INLINE void add_casting_light(const ShadingLight<float>& light, const LitLanes<D>& points, hn::Mask<D> lit,
                                  Vec3Lanes<D>& sum) {
  using V = hn::Vec<D>;
  const D d;
  const V zero = hn::Zero(d);
  const V intensity = hn::Set(d, light.intensity);
  const Vec3Lanes<D> vector = same_in_lanes<D>(light.vector);
  const Vec3Lanes<D> to_light = light.kind == LightKind::point ? subtract(vector, points.position) : vector;
  const V n_dot_l = dot(points.normal, to_light);
  const V light_distance = length_of(to_light);
  add_light(sum, hn::And(lit, hn::Gt(n_dot_l, zero)), light.colour,
            hn::Div(hn::Mul(intensity, n_dot_l), hn::Mul(points.normal_length, light_distance)));
  const hn::Mask<D> shining = hn::And(lit, points.specular);
  if (hn::AllFalse(d, shining)) return;
  const HighlightLanes<D> angle = highlight_lanes(points, to_light, n_dot_l);
  const V product = dot(angle.a, angle.b);
  const hn::Mask<D> bright = hn::And(shining, hn::Gt(product, zero));
  if (hn::AllFalse(d, bright)) return;
  const V cosine = hn::Div(product, hn::Mul(length_of(angle.a), length_of(angle.b)));
  // Where the light so far is not dark, a highlight below a quarter of its last bit is not worth its power.
  const auto largest = std::max({std::abs(light.colour.x), std::abs(light.colour.y), std::abs(light.colour.z)});
  const V dark = hn::Set(d, std::abs(light.intensity) * largest * 0x1p-10f);
  const hn::Mask<D> lost = hn::And(hn::Le(cosine, points.faint), hn::Ge(hn::Min(hn::Min(sum.x, sum.y), sum.z), dark));
  if (hn::AllFalse(d, hn::AndNot(lost, bright))) return;
  const V raised = power_of_floats(d, cosine, points.exponent);
  add_light(sum, bright, light.colour, hn::Mul(intensity, raised));
}

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
