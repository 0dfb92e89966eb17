// Reading a texture for a vector of fragments: image/texture_sampling.h and image/mip_level.h, operation by operation,
// compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_TEXTURE_BATCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#undef PIXELSCOPE_TEXTURE_BATCH_INL_H_
#else
#define PIXELSCOPE_TEXTURE_BATCH_INL_H_
#endif

#include "raster/fast/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace texture {

/// floor_of(), but for the sign of a zero, which is not used here.
HWY_INLINE V floor_of(V value) { return hn::Floor(value); }

/// A whole number below PackedTexture::most_texels: the sum's last digits are the number. A conversion would look for
/// numbers that fit no integer.
HWY_INLINE VI index_of(V whole) {
  const DI di;
  const V shift = number(0x1.8p23f);
  return hn::Sub(hn::BitCast(di, hn::Add(whole, shift)), hn::BitCast(di, shift));
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

/// How many numbers a texel has, as a power of two.
enum class TexelSize { one = 0, four = 2 };
HWY_INLINE TexelSize texel_size(const PackedTexture& texture) {
  return texture.bytes.empty() ? TexelSize::four : TexelSize::one;
}

/// Index of a texel's first number; `x` may be -1 or the level's width.
HWY_INLINE VI texel_index(const Level& level, TexelSize size, VI x, VI y) {
  const VI place = hn::Add(hn::Mul(y, hn::Add(level.width, hn::Set(DI(), 2))), x);
  return hn::Add(level.first, hn::ShiftLeftSame(place, static_cast<int>(size)));
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
  V sum = number(1.0f / 7.0f);
  for (const float next : {1.0f / 5.0f, 1.0f / 3.0f, 1.0f}) sum = hn::Add(hn::Mul(sum, s), number(next));
  return hn::Add(hn::ConvertTo(d, exponent), hn::Mul(hn::Mul(q, sum), number(2.8853900817779268147f)));
}

/// BatchTexture::steps at every lane.
struct Step {
  V u, v, inverse_z;
};
using Steps = std::array<Step, 2>;

/// What uv_derivatives() says of a step's longer way over the texture, squared.
HWY_INLINE V squared_footprint(const BatchTexture& texture, const Steps& steps, V u, V v, V z) {
  const V width = number(static_cast<float>(texture.texture->width[0]));
  const V height = number(static_cast<float>(texture.texture->height[0]));
  const auto squared_length = [&](const Step& step) HWY_ATTR {
    const V du = hn::Mul(hn::Mul(hn::Sub(step.u, hn::Mul(u, step.inverse_z)), z), width);
    const V dv = hn::Mul(hn::Mul(hn::Sub(step.v, hn::Mul(v, step.inverse_z)), z), height);
    return hn::Add(hn::Mul(du, du), hn::Mul(dv, dv));
  };
  const V x = squared_length(steps[0]);
  const V y = squared_length(steps[1]);
  return hn::IfThenElse(hn::Gt(x, y), x, y);
}

/// mip_level() of it.
HWY_INLINE V mip_level(const BatchTexture& texture, V squared) {
  return hn::Add(hn::Mul(number(0.5f), level_log2(squared)), number(texture.mip_bias));
}

/// clamp_level()
HWY_INLINE V clamp_level(V level, const PackedTexture& texture) {
  const V coarsest = number(static_cast<float>(texture.levels - 1));
  return hn::Min(hn::Max(level, hn::Zero(D())), coarsest);
}

/// Adds a vector of fragments to the run.
HWY_INLINE void add_lookups(const BatchTexture& how, const Steps& steps, V u, V v, V z, M seen, Lookups& run) {
  const D d;
  const std::size_t at = run.vectors * hn::Lanes(d);
  run.seen[run.vectors++] = seen;
  hn::Store(u, d, run.u.data() + at);
  hn::Store(v, d, run.v.data() + at);
  if (how.filter == TextureFilter::nearest || how.filter == TextureFilter::bilinear) return;
  hn::Store(squared_footprint(how, steps, u, v, z), d, run.level.data() + at);
}

/// sample_nearest()
HWY_INLINE void place_nearest(const BatchTexture& how, Lookups& run) {
  const DI di;
  const PackedTexture& texture = *how.texture;
  const Level level = level_of(texture, std::size_t{0});
  const auto texel = [&](V t, VI size) HWY_ATTR {
    const VI x = index_of(floor_of(hn::Mul(wrap_coordinate(t, how.wrap), hn::ConvertTo(D(), size))));
    return hn::Min(x, hn::Sub(size, hn::Set(di, 1)));
  };
  for (std::size_t at = 0; at < run.vectors * hn::Lanes(D()); at += hn::Lanes(D())) {
    const VI x = texel(hn::Load(D(), run.u.data() + at), level.width);
    const VI y = texel(hn::Load(D(), run.v.data() + at), level.height);
    hn::Store(texel_index(level, texel_size(texture), x, y), di, run.near.upper.data() + at);
  }
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
  return {index_of(whole), hn::Sub(p, whole)};
}

/// sample_bilinear(), for coordinates already wrapped: which texels the fragments from number `at` on read, and their
/// weights. Columns need no wrapping, for rows go on by a texel at both ends.
HWY_INLINE void place_four(const Level& level, TexelSize size, V t_u, V t_v, TextureWrap wrap, std::size_t at,
                           Lookups::Four& four) {
  const D d;
  const DI di;
  const VI zero = hn::Zero(di), last = hn::Sub(level.height, hn::Set(di, 1));
  const Pair u = texel_pair(t_u, level.width);
  const Pair v = texel_pair(t_v, level.height);
  const bool around = wrap == TextureWrap::repeat;
  const VI first = hn::IfThenElse(hn::Lt(v.first, zero), around ? last : zero, v.first);
  const VI next = hn::Add(v.first, hn::Set(di, 1));
  const VI second = hn::IfThenElse(hn::Gt(next, last), around ? zero : last, next);
  hn::Store(texel_index(level, size, u.first, first), di, four.upper.data() + at);
  hn::Store(texel_index(level, size, u.first, second), di, four.lower.data() + at);
  hn::Store(u.f, d, four.x.data() + at);
  hn::Store(v.f, d, four.y.data() + at);
}

/// Where the levels lie that the fragments read, and in them the texels.
HWY_INLINE void place_filtered(const BatchTexture& how, Lookups& run) {
  const D d;
  const DI di;
  const PackedTexture& texture = *how.texture;
  const TexelSize size = texel_size(texture);
  if (how.filter != TextureFilter::bilinear)
    for (std::size_t at = 0; at < run.vectors * hn::Lanes(d); at += hn::Lanes(d)) {
      float* const level = run.level.data() + at;
      hn::Store(clamp_level(mip_level(how, hn::Load(d, level)), texture), d, level);
    }
  for (std::size_t i = 0, at = 0; i < run.vectors; ++i, at += hn::Lanes(d)) {
    const V t_u = wrap_coordinate(hn::Load(d, run.u.data() + at), how.wrap);
    const V t_v = wrap_coordinate(hn::Load(d, run.v.data() + at), how.wrap);
    if (how.filter == TextureFilter::bilinear) {
      place_four(level_of(texture, std::size_t{0}), size, t_u, t_v, how.wrap, at, run.near);
      continue;
    }
    const V level = hn::Load(d, run.level.data() + at);
    if (how.filter == TextureFilter::mipmap) {
      const VI nearest = index_of(floor_of(hn::Add(level, number(0.5f))));
      place_four(level_of(texture, nearest), size, t_u, t_v, how.wrap, at, run.near);
      continue;
    }
    const V whole = floor_of(level);
    const VI fine = index_of(whole);
    place_four(level_of(texture, fine), size, t_u, t_v, how.wrap, at, run.near);
    const V between = hn::Sub(level, whole);
    hn::Store(between, d, run.between.data() + at);
    run.needs_far[i] = !hn::AllFalse(d, hn::And(hn::Gt(between, hn::Zero(d)), run.seen[i]));
    if (!run.needs_far[i]) continue;
    const VI coarse = hn::Min(hn::Add(fine, hn::Set(di, 1)), hn::Set(di, texture.levels - 1));
    place_four(level_of(texture, coarse), size, t_u, t_v, how.wrap, at, run.far);
  }
}

/// Number of texels that the fragments read.
HWY_INLINE std::uint64_t count_texels(const BatchTexture& how, const Lookups& run) {
  const D d;
  std::uint64_t fragments = 0, mixed = 0;
  for (std::size_t i = 0; i < run.vectors; ++i) {
    fragments += hn::CountTrue(d, run.seen[i]);
    if (how.filter != TextureFilter::trilinear || !run.needs_far[i]) continue;
    const V between = hn::Load(d, run.between.data() + i * hn::Lanes(d));
    mixed += hn::CountTrue(d, hn::And(hn::Gt(between, hn::Zero(d)), run.seen[i]));
  }
  return how.filter == TextureFilter::nearest ? fragments : 4 * (fragments + mixed);
}

/// sample_texture(): fills in the colours of the run's fragments, and adds the texels that they read to `texels`. Lanes
/// without a fragment get anything: their coordinates are wrapped like all others, so what they read lies in the
/// texture.
static HWY_NOINLINE void sample(const BatchTexture& how, Lookups& run, std::uint64_t& texels) {
  const PackedTexture& texture = *how.texture;
  if (how.filter == TextureFilter::nearest) {
    place_nearest(how, run);
    read_nearest(texture, run);
  } else {
    place_filtered(how, run);
    if (how.filter == TextureFilter::trilinear)
      read_trilinear(texture, run);
    else
      read_bilinear(texture, run);
  }
  texels += count_texels(how, run);
}

}  // namespace texture
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
