// Reading a texture for a vector of fragments: image/texture_sampling.h and image/mip_level.h, operation by operation,
// compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_TEXTURE_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#undef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#else
#define PIXELSCOPE_TEXTURE_BATCH_INL_H_
#endif

#include <array>

#include "hwy/highway.h"
#include "math/quarters-inl.h"
#include "raster/packed_texture.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace texture {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;

struct Colour {
  V red, green, blue;
};

HWY_INLINE V number(float value) { return hn::Set(D(), value); }

/// floor_of(), but for the sign of a zero, which nobody here asks for.
HWY_INLINE V floor_of(V value) { return hn::Floor(value); }

/// wrap_coordinate()
HWY_INLINE V wrap_coordinate(V u, TextureWrap wrap) {
  const D d;
  V t = u;
  switch (wrap) {
  case TextureWrap::repeat:
    t = hn::Sub(u, floor_of(u));
    break;
  case TextureWrap::clamp:
    break;
  case TextureWrap::mirror: {
    const V half = hn::Mul(u, number(0.5f));
    t = hn::Mul(hn::Sub(half, floor_of(half)), number(2));
    t = hn::IfThenElse(hn::Gt(t, number(1)), hn::Sub(number(2), t), t);
    break;
  }
  }
  return hn::Min(hn::Max(t, hn::Zero(d)), number(1));  // of NaN and a number both take the number, their second
}

/// One level of the chain for each lane.
struct Level {
  VI first, width, height;
};

HWY_INLINE Level level_of(const PackedTexture& texture, std::size_t level) {
  const DI d;
  return {hn::Set(d, texture.first[level]), hn::Set(d, texture.width[level]), hn::Set(d, texture.height[level])};
}
HWY_INLINE Level level_of(const PackedTexture& texture, VI level) {
  const DI d;
  const std::int32_t one = hn::GetLane(level);
  if (hn::AllTrue(d, hn::Eq(level, hn::Set(d, one)))) return level_of(texture, static_cast<std::size_t>(one));
  return {hn::GatherIndex(d, texture.first.data(), level), hn::GatherIndex(d, texture.width.data(), level),
          hn::GatherIndex(d, texture.height.data(), level)};
}

/// Index of a texel's first number; `x` may be -1 or the level's width.
HWY_INLINE VI texel_index(const Level& level, VI x, VI y) {
  const VI stride = hn::Add(level.width, hn::Set(DI(), 2));
  return hn::Add(level.first, hn::ShiftLeft<2>(hn::Add(hn::Mul(y, stride), x)));
}

// A texel's channels are read at once, for gathering single channels takes longer; and several fragments are mixed at
// once, a quarter of a vector for each: those of lanes k, k + 4, and so on.
using Four = hn::FixedTag<float, 4>;
constexpr std::size_t most_lanes = hn::MaxLanes(D());

/// The first three numbers that make(i) gives for each lane i. Lanes without a fragment get something too: their
/// coordinates are wrapped like all others, so what they read lies in the texture.
template <class Make>
HWY_INLINE Colour by_channels(Make&& make) {
  const auto colour = ps::HWY_NAMESPACE::four_vectors(make);
  return {colour.first, colour.second, colour.third};
}

/// The same where make(k) gives them for lanes k, k + 4, ... at once.
template <class Make>
HWY_INLINE Colour by_quarters(Make&& make) {
  const auto colour = ps::HWY_NAMESPACE::four_vectors_of_quarters(make);
  return {colour.first, colour.second, colour.third};
}

/// sample_nearest()
HWY_INLINE Colour sample_nearest(const PackedTexture& texture, V u, V v, TextureWrap wrap) {
  const DI di;
  const Level level = level_of(texture, std::size_t{0});
  const auto texel = [&](V t, VI size) HWY_ATTR {
    const VI x = hn::ConvertTo(di, hn::Mul(wrap_coordinate(t, wrap), hn::ConvertTo(D(), size)));
    return hn::Min(x, hn::Sub(size, hn::Set(di, 1)));
  };
  HWY_ALIGN std::int32_t index[most_lanes];
  hn::Store(texel_index(level, texel(u, level.width), texel(v, level.height)), di, index);
  return by_channels([&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), texture.texels.data() + index[i]); });
}

/// texel_pair() before the neighbours are wrapped; `t` is a wrapped coordinate. `first` lies in [-1, size).
struct Pair {
  VI first;
  V f;
};
HWY_INLINE Pair texel_pair(V t, VI size) {
  const D d;
  const V p = hn::Sub(hn::Mul(t, hn::ConvertTo(d, size)), number(0.5f));
  const V whole = floor_of(p);
  return {hn::ConvertTo(DI(), whole), hn::Sub(p, whole)};
}

/// A weight and what it leaves to one, for each fragment.
struct Weights {
  V f, rest;
  HWY_INLINE void set(V value) {
    f = value;
    rest = hn::Sub(number(1), value);
  }
  template <int k>
  HWY_INLINE V mix(V a, V b) const {
    return hn::Add(hn::Mul(a, hn::Broadcast<k>(rest)), hn::Mul(b, hn::Broadcast<k>(f)));
  }
};

/// sample_bilinear(), for coordinates already wrapped: which texels each fragment reads, and their weights. Columns
/// need no wrapping, for rows go on by a texel at both ends.
struct Bilinear {
  HWY_ALIGN std::int32_t upper[most_lanes];
  HWY_ALIGN std::int32_t lower[most_lanes];
  Weights x, y;

  HWY_INLINE void set(const Level& level, V t_u, V t_v, TextureWrap wrap) {
    const DI di;
    const VI zero = hn::Zero(di), last = hn::Sub(level.height, hn::Set(di, 1));
    const Pair u = texel_pair(t_u, level.width);
    const Pair v = texel_pair(t_v, level.height);
    const bool around = wrap == TextureWrap::repeat;
    const VI first = hn::IfThenElse(hn::Lt(v.first, zero), around ? last : zero, v.first);
    const VI next = hn::Add(v.first, hn::Set(di, 1));
    const VI second = hn::IfThenElse(hn::Gt(next, last), around ? zero : last, next);
    hn::Store(texel_index(level, u.first, first), di, upper);
    hn::Store(texel_index(level, u.first, second), di, lower);
    x.set(u.f);
    y.set(v.f);
  }
  /// The colours of lanes k, k + 4, ...
  template <int k>
  HWY_INLINE V read(const float* texels) const {
    return y.mix<k>(mix_row<k>(texels, upper), mix_row<k>(texels, lower));
  }

 private:
  template <int k>
  HWY_INLINE V mix_row(const float* texels, const std::int32_t* index) const {
    const auto left = [&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), texels + index[i]); };
    const auto right = [&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), texels + index[i] + 4); };
    return x.mix<k>(ps::HWY_NAMESPACE::every_fourth(left, k), ps::HWY_NAMESPACE::every_fourth(right, k));
  }
};

/// level_log2()
HWY_INLINE V level_log2(V value) {
  const D d;
  const DI di;
  const VI bits = hn::BitCast(di, value);
  const VI exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3f3504f3)));
  const V mantissa = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  const V q = hn::Div(hn::Sub(mantissa, number(1)), hn::Add(mantissa, number(1)));
  const V s = hn::Mul(q, q);
  V sum = number(1.0f / 11.0f);
  for (const float next : {1.0f / 9.0f, 1.0f / 7.0f, 1.0f / 5.0f, 1.0f / 3.0f, 1.0f})
    sum = hn::Add(hn::Mul(sum, s), number(next));
  return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(hn::Mul(q, sum), number(2.8853900817779268147f)));
}

/// BatchTexture::steps at every lane.
struct Step {
  V u, v, inverse_z;
};
using Steps = std::array<Step, 2>;

/// mip_level() of uv_derivatives().
HWY_INLINE V mip_level(const BatchTexture& texture, const Steps& steps, V u, V v, V z) {
  const V width = number(static_cast<float>(texture.texture->width[0]));
  const V height = number(static_cast<float>(texture.texture->height[0]));
  const auto squared_length = [&](const Step& step) HWY_ATTR {
    const V du = hn::Mul(hn::Mul(hn::Sub(step.u, hn::Mul(u, step.inverse_z)), z), width);
    const V dv = hn::Mul(hn::Mul(hn::Sub(step.v, hn::Mul(v, step.inverse_z)), z), height);
    return hn::Add(hn::Mul(du, du), hn::Mul(dv, dv));
  };
  const V x = squared_length(steps[0]);
  const V y = squared_length(steps[1]);
  const V longer = hn::IfThenElse(hn::Gt(x, y), x, y);
  return hn::Add(hn::Mul(number(0.5f), level_log2(longer)), number(texture.mip_bias));
}

/// clamp_level()
HWY_INLINE V clamp_level(V level, const PackedTexture& texture) {
  const V coarsest = number(static_cast<float>(texture.levels - 1));
  return hn::Min(hn::Max(level, hn::Zero(D())), coarsest);
}

/// sample_texture(): the colours of the lanes in `seen`, and the texels that these read added to `texels`. The other
/// lanes get anything.
static HWY_NOINLINE Colour sample(const BatchTexture& how, const Steps& steps, V u, V v, V z, M seen,
                                  std::uint64_t& texels) {
  const D d;
  const DI di;
  const PackedTexture& texture = *how.texture;
  const std::uint64_t count = hn::CountTrue(d, seen);
  if (how.filter == TextureFilter::nearest) {
    texels += count;
    return sample_nearest(texture, u, v, how.wrap);
  }
  texels += 4 * count;
  const float* all = texture.texels.data();
  const V t_u = wrap_coordinate(u, how.wrap);
  const V t_v = wrap_coordinate(v, how.wrap);
  Bilinear near;
  const auto of_near = [&](auto k) HWY_ATTR { return near.read<k>(all); };
  if (how.filter == TextureFilter::bilinear) {
    near.set(level_of(texture, std::size_t{0}), t_u, t_v, how.wrap);
    return by_quarters(of_near);
  }
  const V level = clamp_level(mip_level(how, steps, u, v, z), texture);
  if (how.filter == TextureFilter::mipmap) {
    near.set(level_of(texture, hn::ConvertTo(di, hn::Add(level, number(0.5f)))), t_u, t_v, how.wrap);
    return by_quarters(of_near);
  }
  const VI fine = hn::ConvertTo(di, level);
  near.set(level_of(texture, fine), t_u, t_v, how.wrap);
  Weights between;
  between.set(hn::Sub(level, hn::ConvertTo(d, fine)));
  const M mixed = hn::And(hn::Gt(between.f, hn::Zero(d)), seen);
  if (hn::AllFalse(d, mixed)) return by_quarters(of_near);
  const std::uint64_t both = hn::CountTrue(d, mixed);
  texels += 4 * both;
  const VI coarse = hn::Min(hn::Add(fine, hn::Set(di, 1)), hn::Set(di, texture.levels - 1));
  Bilinear far;
  far.set(level_of(texture, coarse), t_u, t_v, how.wrap);
  if (both == count)
    return by_quarters([&](auto k) HWY_ATTR { return between.mix<k>(near.read<k>(all), far.read<k>(all)); });
  return by_quarters([&](auto k) HWY_ATTR {
    const V texel = near.read<k>(all);
    const M is_mixed = hn::Gt(hn::Broadcast<k>(between.f), hn::Zero(D()));
    return hn::IfThenElse(is_mixed, between.mix<k>(texel, far.read<k>(all)), texel);
  });
}

}  // namespace texture
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
