// Reading a texture for a vector of fragments: image/texture_sampling.h and image/mip_level.h, operation by operation,
// compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_TEXTURE_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#undef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#else
#define PIXELSCOPE_TEXTURE_BATCH_INL_H_
#endif

#include "hwy/highway.h"
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

/// floor_of()
HWY_INLINE V floor_of(V value) {
  const D d;
  const V cut = hn::ConvertTo(d, hn::ConvertTo(DI(), value));
  const V whole = hn::IfThenElse(hn::Gt(cut, value), hn::Sub(cut, number(1)), cut);
  const M fits = hn::And(hn::Gt(value, number(-1073741824.0f)), hn::Lt(value, number(1073741824.0f)));
  return hn::IfThenElse(fits, whole, hn::Floor(value));
}

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
  const V most_one = hn::IfThenElse(hn::Lt(t, number(1)), t, number(1));
  return hn::IfThenElse(hn::Gt(t, hn::Zero(d)), most_one, hn::Zero(d));
}

/// One level of the chain for each lane.
struct Level {
  VI first, width, height;
};

HWY_INLINE Level level_of(const PackedTexture& texture, VI level) {
  const DI d;
  return {hn::GatherIndex(d, texture.first.data(), level), hn::GatherIndex(d, texture.width.data(), level),
          hn::GatherIndex(d, texture.height.data(), level)};
}
HWY_INLINE Level level_zero(const PackedTexture& texture) {
  const DI d;
  return {hn::Set(d, texture.first[0]), hn::Set(d, texture.width[0]), hn::Set(d, texture.height[0])};
}

/// read_texel()
HWY_INLINE Colour read(const PackedTexture& texture, VI texel) {
  const D d;
  const float* base = texture.texels.data();
  return {hn::GatherIndex(d, base, texel), hn::GatherIndex(d, base + 1, texel), hn::GatherIndex(d, base + 2, texel)};
}
HWY_INLINE VI texel_index(const Level& level, VI x, VI y) {
  const VI flat = hn::Add(hn::Mul(y, level.width), x);
  return hn::Add(level.first, hn::Add(hn::Add(flat, flat), flat));
}

HWY_INLINE V mix(V a, V b, V f) { return hn::Add(hn::Mul(a, hn::Sub(number(1), f)), hn::Mul(b, f)); }
HWY_INLINE Colour mix(const Colour& a, const Colour& b, V f) {
  return {mix(a.red, b.red, f), mix(a.green, b.green, f), mix(a.blue, b.blue, f)};
}

/// sample_nearest()
HWY_INLINE Colour sample_nearest(const PackedTexture& texture, const Level& level, V u, V v, TextureWrap wrap) {
  const DI di;
  const auto texel = [&](V t, VI size) HWY_ATTR {
    const VI x = hn::ConvertTo(di, hn::Mul(wrap_coordinate(t, wrap), hn::ConvertTo(D(), size)));
    return hn::Min(x, hn::Sub(size, hn::Set(di, 1)));
  };
  return read(texture, texel_index(level, texel(u, level.width), texel(v, level.height)));
}

/// texel_pair(); `t` is a wrapped coordinate.
struct Pair {
  VI first, second;
  V f;
};
HWY_INLINE Pair texel_pair(V t, VI size, TextureWrap wrap) {
  const D d;
  const DI di;
  const VI zero = hn::Zero(di);
  const VI last = hn::Sub(size, hn::Set(di, 1));
  const V p = hn::Sub(hn::Mul(t, hn::ConvertTo(d, size)), number(0.5f));
  const V whole = floor_of(p);
  const VI x = hn::ConvertTo(di, whole);
  const VI next = hn::Add(x, hn::Set(di, 1));
  const bool around = wrap == TextureWrap::repeat;
  const auto inside = [&](VI i) HWY_ATTR {
    const VI low = hn::IfThenElse(hn::Lt(i, zero), around ? last : zero, i);
    return hn::IfThenElse(hn::Gt(i, last), around ? zero : last, low);
  };
  return {inside(x), inside(next), hn::Sub(p, whole)};
}

/// sample_bilinear(), for coordinates already wrapped.
HWY_INLINE Colour sample_bilinear(const PackedTexture& texture, const Level& level, V t_u, V t_v, TextureWrap wrap) {
  const Pair x = texel_pair(t_u, level.width, wrap);
  const Pair y = texel_pair(t_v, level.height, wrap);
  const Colour top = mix(read(texture, texel_index(level, x.first, y.first)),
                         read(texture, texel_index(level, x.second, y.first)), x.f);
  const Colour bottom = mix(read(texture, texel_index(level, x.first, y.second)),
                            read(texture, texel_index(level, x.second, y.second)), x.f);
  return mix(top, bottom, y.f);
}

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

/// mip_level() of uv_derivatives().
HWY_INLINE V mip_level(const BatchTexture& texture, V u, V v, V z) {
  const V width = number(static_cast<float>(texture.texture->width[0]));
  const V height = number(static_cast<float>(texture.texture->height[0]));
  const auto squared_length = [&](const BatchTexture::Step& step) HWY_ATTR {
    const V depth = number(step.inverse_z);
    const V du = hn::Mul(hn::Mul(hn::Sub(number(step.u), hn::Mul(u, depth)), z), width);
    const V dv = hn::Mul(hn::Mul(hn::Sub(number(step.v), hn::Mul(v, depth)), z), height);
    return hn::Add(hn::Mul(du, du), hn::Mul(dv, dv));
  };
  const V x = squared_length(texture.steps[0]);
  const V y = squared_length(texture.steps[1]);
  const V longer = hn::IfThenElse(hn::Gt(x, y), x, y);
  return hn::Add(hn::Mul(number(0.5f), level_log2(longer)), number(texture.mip_bias));
}

/// clamp_level()
HWY_INLINE V clamp_level(V level, const PackedTexture& texture) {
  const V coarsest = number(static_cast<float>(texture.levels - 1));
  const V most = hn::IfThenElse(hn::Lt(level, coarsest), level, coarsest);
  return hn::IfThenElse(hn::Gt(level, hn::Zero(D())), most, hn::Zero(D()));
}

/// sample_texture(): the colour, and the texels read by the first `count` lanes added to `texels`.
HWY_INLINE Colour sample(const BatchTexture& how, V u, V v, V z, std::size_t count, std::uint64_t& texels) {
  const D d;
  const DI di;
  const PackedTexture& texture = *how.texture;
  if (how.filter == TextureFilter::nearest) {
    texels += count;
    return sample_nearest(texture, level_zero(texture), u, v, how.wrap);
  }
  texels += 4 * count;
  const V t_u = wrap_coordinate(u, how.wrap);
  const V t_v = wrap_coordinate(v, how.wrap);
  if (how.filter == TextureFilter::bilinear) return sample_bilinear(texture, level_zero(texture), t_u, t_v, how.wrap);
  const V level = clamp_level(mip_level(how, u, v, z), texture);
  if (how.filter == TextureFilter::mipmap) {
    const VI nearest = hn::ConvertTo(di, hn::Add(level, number(0.5f)));
    return sample_bilinear(texture, level_of(texture, nearest), t_u, t_v, how.wrap);
  }
  const VI fine = hn::ConvertTo(di, level);
  const V f = hn::Sub(level, hn::ConvertTo(d, fine));
  const Colour near = sample_bilinear(texture, level_of(texture, fine), t_u, t_v, how.wrap);
  const M mixed = hn::And(hn::Gt(f, hn::Zero(d)), hn::FirstN(d, count));
  if (hn::AllFalse(d, mixed)) return near;
  texels += 4 * hn::CountTrue(d, mixed);
  // Lanes at the coarsest level have f = 0 and read it again.
  const VI coarse = hn::Min(hn::Add(fine, hn::Set(di, 1)), hn::Set(di, texture.levels - 1));
  const Colour both = mix(near, sample_bilinear(texture, level_of(texture, coarse), t_u, t_v, how.wrap), f);
  const M blend = hn::Gt(f, hn::Zero(d));
  return {hn::IfThenElse(blend, both.red, near.red), hn::IfThenElse(blend, both.green, near.green),
          hn::IfThenElse(blend, both.blue, near.blue)};
}

}  // namespace texture
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
