#include "raster/shade_batch.h"

#include <algorithm>

#include "options/simd_choice.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/shade_batch.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "math/power-inl.h"
#include "math/vec3-inl.h"
#include "raster/texture_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

using V3 = ps::HWY_NAMESPACE::Vec3Lanes<D>;

HWY_INLINE V splat(float value) { return hn::Set(D(), value); }
HWY_INLINE V3 splat3(const Vec3f& value) { return ps::HWY_NAMESPACE::same_in_lanes<D>(value); }

/// Fragments of one triangle, whose numbers begin at `row`: interpolate() of raster/fragment.h.
class OneTriangle {
 public:
  HWY_INLINE OneTriangle(const BatchShading& shading, const ShadeBatch& batch, int lane, const float* row)
      : shading_(shading), row_(row), z_(hn::LoadU(D(), batch.z.data() + lane)) {
    for (std::size_t i = 0; i < 3; ++i) weights_[i] = hn::LoadU(D(), batch.weights[i].data() + lane);
  }
  HWY_INLINE V scalar(int slot) const {
    const float* a = row_ + slot;
    const V sum = hn::Add(hn::Add(hn::Mul(weights_[0], splat(a[0])), hn::Mul(weights_[1], splat(a[shading_.stride]))),
                          hn::Mul(weights_[2], splat(a[2 * shading_.stride])));
    return hn::Mul(sum, z_);
  }
  HWY_INLINE V3 vector(int slot) const { return {scalar(slot), scalar(slot + 1), scalar(slot + 2)}; }
  HWY_INLINE V3 pair(int slot) const { return {scalar(slot), scalar(slot + 1), hn::Zero(D())}; }
  HWY_INLINE V3 constant(int at) const { return {splat(row_[at]), splat(row_[at + 1]), splat(row_[at + 2])}; }

 private:
  const BatchShading& shading_;
  const float* row_;
  std::array<V, 3> weights_;
  V z_;
};

/// Fragments of different triangles: four scalars of one fragment at a time, the same operations.
class ManyTriangles {
 public:
  HWY_INLINE ManyTriangles(const BatchShading& shading, const ShadeBatch& batch, int lane, int count)
      : shading_(shading), batch_(batch), lane_(static_cast<std::size_t>(lane)),
        count_(static_cast<std::size_t>(count)) {}
  HWY_INLINE V3 vector(int slot) const {
    const Four four;
    return transposed([&](const float* row, std::size_t i) HWY_ATTR {
      const float* a = row + slot;
      const auto part = [&](std::size_t k) HWY_ATTR {
        return hn::Mul(hn::Set(four, batch_.weights[k][i]),
                       hn::Load(four, a + k * static_cast<std::size_t>(shading_.stride)));
      };
      return hn::Mul(hn::Add(hn::Add(part(0), part(1)), part(2)), hn::Set(four, batch_.z[i]));
    });
  }
  HWY_INLINE V3 pair(int slot) const { return vector(slot); }
  HWY_INLINE V3 constant(int at) const {
    return transposed([&](const float* row, std::size_t) HWY_ATTR { return hn::Load(Four(), row + at); });
  }

 private:
  using Four = hn::FixedTag<float, 4>;

  /// The first three scalars of make(row, i) for each fragment i.
  template <class Make>
  HWY_INLINE V3 transposed(Make&& make) const {
    HWY_ALIGN float buffer[4 * hn::MaxLanes(D())] = {};
    for (std::size_t i = 0; i < count_; ++i) {
      const float* row = shading_.attributes + static_cast<std::ptrdiff_t>(batch_.rows[lane_ + i]) * shading_.row_size;
      hn::Store(make(row, lane_ + i), Four(), buffer + 4 * i);
    }
    V3 result;
    V unused;
    hn::LoadInterleaved4(D(), buffer, result.x, result.y, result.z, unused);
    return result;
  }

  const BatchShading& shading_;
  const ShadeBatch& batch_;
  std::size_t lane_, count_;
};

template <class Source>
HWY_INLINE texture::Colour read_texture(const BatchShading& shading, const Source& source, ShadeBatch& batch, int lane,
                                        int count) {
  const V3 uv = source.pair(shading.texture.uv);
  texture::Steps steps;
  for (std::size_t i = 0; i < 2; ++i) {
    const BatchTexture::Step& step = shading.texture.steps[i];
    V3 change{splat(step.u), splat(step.v), splat(step.inverse_z)};
    if (shading.steps_at >= 0) change = source.constant(shading.steps_at + 4 * static_cast<int>(i));
    steps[i] = {change.x, change.y, change.z};
  }
  return texture::sample(shading.texture, steps, uv.x, uv.y, hn::LoadU(D(), batch.z.data() + lane),
                         static_cast<std::size_t>(count), batch.texels);
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

template <class Source>
HWY_INLINE V3 light_of_equation(const BatchShading& shading, const Source& source) {
  const V zero = hn::Zero(D());
  V3 normal = splat3(shading.face_normal);
  if (shading.face_normal_at >= 0) normal = source.constant(shading.face_normal_at);
  if (shading.normal >= 0) normal = source.vector(shading.normal);
  V3 position{zero, zero, zero};
  if (shading.position >= 0) position = source.vector(shading.position);
  if (shading.renormalise) {
    const V size = length(normal);
    normal = choose(hn::Gt(size, zero), divide(normal, size), normal);
  }
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

HWY_INLINE void store(const V3& colour, ShadeBatch& batch, int lane) {
  const D d;
  hn::StoreU(colour.x, d, batch.red.data() + lane);
  hn::StoreU(colour.y, d, batch.green.data() + lane);
  hn::StoreU(colour.z, d, batch.blue.data() + lane);
}

template <class Source>
HWY_INLINE void shade_vector(const BatchShading& shading, const Source& source, ShadeBatch& batch, int lane,
                             int count) {
  const V zero = hn::Zero(D());
  // The surface's own colour: the material's, times the texture's.
  V3 colour = splat3(shading.colour);
  if (shading.texture.texture) {
    const texture::Colour texel = read_texture(shading, source, batch, lane, count);
    colour = {hn::Mul(colour.x, texel.red), hn::Mul(colour.y, texel.green), hn::Mul(colour.z, texel.blue)};
  }
  V3 sum{zero, zero, zero};
  switch (shading.source) {
  case BatchLight::none:
    return store(colour, batch, lane);
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
  store({hn::Add(hn::Mul(colour.x, sum.x), zero), hn::Add(hn::Mul(colour.y, sum.y), zero),
         hn::Add(hn::Mul(colour.z, sum.z), zero)},
        batch, lane);
}

/// Whether all of `count` fragments are of one triangle.
HWY_INLINE bool of_one_triangle(const ShadeBatch& batch, int lane, int count) {
  const hn::Rebind<std::int32_t, D> di;
  const auto rows = hn::LoadU(di, batch.rows.data() + lane);
  const auto same = hn::Eq(rows, hn::Set(di, batch.rows[static_cast<std::size_t>(lane)]));
  return hn::AllTrue(di, hn::Or(same, hn::Not(hn::FirstN(di, static_cast<std::size_t>(count)))));
}

}  // namespace

void shade_fragments(const BatchShading& shading, ShadeBatch& batch, int first, int last);

void shade_fragments(const BatchShading& shading, ShadeBatch& batch, int first, int last) {
  const int lanes = static_cast<int>(hn::Lanes(D()));
  for (int lane = first; lane < last; lane += lanes) {
    const int count = std::min(lanes, last - lane);
    if (shading.row_size == 0) {
      shade_vector(shading, OneTriangle(shading, batch, lane, shading.attributes), batch, lane, count);
    } else if (of_one_triangle(batch, lane, count)) {
      const float* row = shading.attributes +
                         static_cast<std::ptrdiff_t>(batch.rows[static_cast<std::size_t>(lane)]) * shading.row_size;
      shade_vector(shading, OneTriangle(shading, batch, lane, row), batch, lane, count);
    } else {
      shade_vector(shading, ManyTriangles(shading, batch, lane, count), batch, lane, count);
    }
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
