// Shading of a vector of fragments: shade_fragment.h and shade/illumination.h, operation by operation, compiled once
// for each SIMD target (Highway).
#if defined(PIXELSCOPE_SHADE_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_SHADE_BATCH_INL_H_
#undef PIXELSCOPE_SHADE_BATCH_INL_H_
#else
#define PIXELSCOPE_SHADE_BATCH_INL_H_
#endif

#include "math/vec3-inl.h"
#include "raster/fast/shade_batch.h"
#include "raster/fast/texture_batch-inl.h"
#include "shade/illumination-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace shading {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

using V3 = ps::HWY_NAMESPACE::Vec3Lanes<D>;

HWY_INLINE V splat(float value) { return hn::Set(D(), value); }
HWY_INLINE V3 splat3(const Vec3f& value) { return ps::HWY_NAMESPACE::same_in_lanes<D>(value); }

// A Source gives what the fragments' triangles carry: vector(slot) and pair(slot) interpolate three or two scalars of
// the vertices, constant(at) reads three of the triangle's own.

/// Adds a vector of fragments to those whose texture will be read.
template <class Source>
HWY_INLINE void add_lookups(const BatchShading& shading, const Source& source, V z, M seen, texture::Lookups& run) {
  const V3 uv = source.pair(shading.texture.uv);
  texture::Steps steps;
  for (std::size_t i = 0; i < 2; ++i) {
    const BatchTexture::Step& step = shading.texture.steps[i];
    V3 change{splat(step.u), splat(step.v), splat(step.inverse_z)};
    if (shading.steps_at >= 0) change = source.constant(shading.steps_at + 4 * static_cast<int>(i));
    steps[i] = {change.x, change.y, change.z};
  }
  texture::add_lookups(shading.texture, steps, uv.x, uv.y, z, seen, run);
}

/// The surface's colour: the material's, times the texture's, which has been read for vector `i` of the run.
HWY_INLINE V3 own_colour(const BatchShading& shading, const texture::Lookups& run, std::size_t i) {
  const V3 colour = splat3(shading.colour);
  if (!shading.texture.texture) return colour;
  const auto times = [&](V own, const texture::Lookups::Numbers& texels)
                         HWY_ATTR { return hn::Mul(own, hn::Load(D(), texels.data() + i * hn::Lanes(D()))); };
  return {times(colour.x, run.red), times(colour.y, run.green), times(colour.z, run.blue)};
}

template <class Source>
HWY_INLINE V3 light_of_equation(const BatchShading& shading, const Source& source) {
  const V zero = hn::Zero(D());
  V3 normal = splat3(shading.face_normal);
  if (shading.face_normal_at >= 0) normal = source.constant(shading.face_normal_at);
  if (shading.normal >= 0) normal = source.vector(shading.normal);
  V3 position{zero, zero, zero};
  if (shading.position >= 0) position = source.vector(shading.position);
  if (shading.renormalise) normal = unit_or_zero(normal);
  const M all = hn::Eq(zero, zero);
  const M specular = shading.specular ? all : hn::Not(all);
  const ps::HWY_NAMESPACE::LitLanes<D> points{position,
                                              normal,
                                              subtract(splat3(shading.eye), position),
                                              length_of(normal),
                                              specular,
                                              splat(shading.exponent),
                                              splat(shading.faint),
                                              shading.highlight};
  V3 sum{zero, zero, zero};
  for (const ShadingLight<float>& light : shading.lights) {
    if (light.kind == LightKind::ambient)
      add_light(sum, all, light.colour, splat(light.intensity));
    else
      add_casting_light(light, points, all, sum);
  }
  return sum;
}

/// The colours of fragments whose surface colour is `colour`.
template <class Source>
HWY_INLINE V3 light_vector(const BatchShading& shading, const Source& source, const V3& colour) {
  const V zero = hn::Zero(D());
  V3 sum{zero, zero, zero};
  switch (shading.source) {
  case BatchLight::none:
    return colour;
  case BatchLight::constant:
    sum = splat3(shading.constant);
    break;
  case BatchLight::corners:
    if (shading.light >= 0) sum = source.vector(shading.light);
    break;
  case BatchLight::equation:
    sum = light_of_equation(shading, source);
    break;
  }
  return {hn::Add(hn::Mul(colour.x, sum.x), zero), hn::Add(hn::Mul(colour.y, sum.y), zero),
          hn::Add(hn::Mul(colour.z, sum.z), zero)};
}

/// The colours of a single vector's fragments in the lanes of `seen`; the others get anything. `z` is the fragments'
/// depth in camera space. Adds the texels that were read.
template <class Source>
HWY_INLINE V3 shade_vector(const BatchShading& shading, const Source& source, V z, M seen, std::uint64_t& texels) {
  texture::Lookups run;
  if (shading.texture.texture) {
    add_lookups(shading, source, z, seen, run);
    texture::sample(shading.texture, run, texels);
  }
  return light_vector(shading, source, own_colour(shading, run, 0));
}

}  // namespace shading
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
