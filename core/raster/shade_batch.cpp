#include "raster/shade_batch.h"

#include <algorithm>

#include "raster/simd_choice.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shade_batch.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "math/power-inl.h"
#include "raster/texture_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct V3 {
  V x, y, z;
};

HWY_INLINE V splat(float value) { return hn::Set(D(), value); }
HWY_INLINE V3 splat3(const Vec3f& value) { return {splat(value.x), splat(value.y), splat(value.z)}; }
HWY_INLINE V3 add(const V3& a, const V3& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 subtract(const V3& a, const V3& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V3 scale(const V3& a, V factor) {
  return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}
HWY_INLINE V3 divide(const V3& a, V divisor) {
  return {hn::Div(a.x, divisor), hn::Div(a.y, divisor), hn::Div(a.z, divisor)};
}
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V length(const V3& a) { return hn::Sqrt(dot(a, a)); }
HWY_INLINE V3 choose(M mask, const V3& yes, const V3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

/// One scalar of the layout at every lane: interpolate() of raster/fragment.h.
HWY_INLINE V interpolate(const BatchShading& shading, const ShadeBatch& batch, int lane, int slot) {
  const D d;
  const float* a = shading.attributes + slot;
  const auto weight = [&](std::size_t i) HWY_ATTR { return hn::Load(d, batch.weights[i].data() + lane); };
  const V sum = hn::Add(hn::Add(hn::Mul(weight(0), splat(a[0])), hn::Mul(weight(1), splat(a[shading.stride]))),
                        hn::Mul(weight(2), splat(a[2 * shading.stride])));
  return hn::Mul(sum, hn::Load(d, batch.z.data() + lane));
}

HWY_INLINE V3 interpolate3(const BatchShading& shading, const ShadeBatch& batch, int lane, int slot,
                           const Vec3f& otherwise) {
  if (slot < 0) return splat3(otherwise);
  return {interpolate(shading, batch, lane, slot), interpolate(shading, batch, lane, slot + 1),
          interpolate(shading, batch, lane, slot + 2)};
}

HWY_INLINE void add_light(V3& sum, M mask, const Vec3f& colour, V amount) {
  const V3 more{hn::Add(sum.x, hn::Mul(splat(colour.x), amount)), hn::Add(sum.y, hn::Mul(splat(colour.y), amount)),
                hn::Add(sum.z, hn::Mul(splat(colour.z), amount))};
  sum = choose(mask, more, sum);
}

/// One point or directional light: diffuse, then its highlight.
HWY_INLINE void add_casting_light(const BatchShading& shading, const ShadingLight<float>& light, const V3& position,
                                  const V3& normal, V normal_length, V3& sum) {
  const D d;
  const V zero = hn::Zero(d);
  const V intensity = splat(light.intensity);
  const V3 vector = splat3(light.vector);
  const V3 to_light = light.kind == LightKind::point ? subtract(vector, position) : vector;
  const V n_dot_l = dot(normal, to_light);
  const V light_distance = length(to_light);
  add_light(sum, hn::Gt(n_dot_l, zero), light.colour,
            hn::Div(hn::Mul(intensity, n_dot_l), hn::Mul(normal_length, light_distance)));
  if (!shading.specular) return;
  V3 a = normal;
  V3 b = subtract(splat3(shading.eye), position);
  switch (shading.highlight) {
  case Highlight::phong:
    a = subtract(scale(normal, hn::Mul(splat(2), n_dot_l)), to_light);
    break;
  case Highlight::blinn_phong:
    b = add(divide(to_light, light_distance), divide(b, length(b)));
    break;
  }
  const V product = dot(a, b);
  const M bright = hn::Gt(product, zero);
  if (hn::AllFalse(d, bright)) return;
  const V cosine = hn::Div(product, hn::Mul(length(a), length(b)));
  const V raised = ps::HWY_NAMESPACE::power_of_floats(d, cosine, splat(shading.exponent));
  add_light(sum, bright, light.colour, hn::Mul(intensity, raised));
}

HWY_INLINE V3 light_of_equation(const BatchShading& shading, const ShadeBatch& batch, int lane) {
  const D d;
  const V zero = hn::Zero(d);
  V3 normal = interpolate3(shading, batch, lane, shading.normal, shading.face_normal);
  if (shading.renormalise) {
    const V size = length(normal);
    normal = choose(hn::Gt(size, zero), divide(normal, size), normal);
  }
  const V3 position = interpolate3(shading, batch, lane, shading.position, Vec3f(0));
  const V normal_length = length(normal);
  V3 sum{zero, zero, zero};
  for (const ShadingLight<float>& light : shading.lights) {
    if (light.kind == LightKind::ambient)
      add_light(sum, hn::Eq(zero, zero), light.colour, splat(light.intensity));
    else
      add_casting_light(shading, light, position, normal, normal_length, sum);
  }
  return sum;
}

/// The surface's own colour: the material's, times the texture's.
HWY_INLINE V3 surface_colour(const BatchShading& shading, ShadeBatch& batch, int lane) {
  const V3 colour = splat3(shading.colour);
  if (!shading.texture.texture) return colour;
  const V u = interpolate(shading, batch, lane, shading.texture.uv);
  const V v = interpolate(shading, batch, lane, shading.texture.uv + 1);
  const auto count = std::min(hn::Lanes(D()), static_cast<std::size_t>(batch.count - lane));
  const texture::Colour texel =
      texture::sample(shading.texture, u, v, hn::Load(D(), batch.z.data() + lane), count, batch.texels);
  return {hn::Mul(colour.x, texel.red), hn::Mul(colour.y, texel.green), hn::Mul(colour.z, texel.blue)};
}

HWY_INLINE void store(D d, const V3& colour, ShadeBatch& batch, int lane) {
  hn::Store(colour.x, d, batch.red.data() + lane);
  hn::Store(colour.y, d, batch.green.data() + lane);
  hn::Store(colour.z, d, batch.blue.data() + lane);
}

}  // namespace

void shade_fragments(const BatchShading& shading, ShadeBatch& batch) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const V zero = hn::Zero(d);
  for (int lane = 0; lane < batch.count; lane += lanes) {
    const V3 colour = surface_colour(shading, batch, lane);
    V3 sum{zero, zero, zero};
    switch (shading.source) {
    case BatchLight::none:
      store(d, colour, batch, lane);
      continue;
    case BatchLight::constant:
      sum = splat3(shading.constant);
      break;
    case BatchLight::corners:
      sum = interpolate3(shading, batch, lane, shading.light, Vec3f(0));
      break;
    case BatchLight::equation:
      sum = light_of_equation(shading, batch, lane);
      break;
    }
    store(d,
          {hn::Add(hn::Mul(colour.x, sum.x), zero), hn::Add(hn::Mul(colour.y, sum.y), zero),
           hn::Add(hn::Mul(colour.z, sum.z), zero)},
          batch, lane);
  }
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

ShadeFragments shade_function(Simd simd) {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  if (may_use(simd, Simd::avx512, have, HWY_AVX3)) return N_AVX3::shade_fragments;
  if (may_use(simd, Simd::avx2, have, HWY_AVX2)) return N_AVX2::shade_fragments;
  if (may_use(simd, Simd::sse4, have, HWY_SSE4)) return N_SSE4::shade_fragments;
#else
  static_cast<void>(simd);
#endif
  return nullptr;
}

}  // namespace ps::raster
#endif
