// Texels of a run of fragments, read and mixed as image/texture_sampling.h does; compiled once for each SIMD target
// (Highway).
#if defined(PIXELSCOPE_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_TEXELS_INL_H_
#undef PIXELSCOPE_TEXELS_INL_H_
#else
#define PIXELSCOPE_TEXELS_INL_H_
#endif

#include <array>
#include <type_traits>

#include "hwy/highway.h"
#include "math/quarters-inl.h"
#include "raster/fast/packed_texture.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace texture {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<D>;

HWY_INLINE V number(float value) { return hn::Set(D(), value); }

/// A run of fragments that read one texture: vector after vector, with what sample() finds out about each on its way.
/// Every step is taken for the whole run before the next one begins, so that the processor works on several vectors at
/// once and not on one long chain of operations that wait for each other.
struct Lookups {
  static constexpr std::size_t most = 64;  ///< fragments
  static constexpr std::size_t most_vectors = most / hn::MaxLanes(D());
  using Numbers = std::array<float, most>;
  using Indices = std::array<std::int32_t, most>;

  /// One level's four texels around each point. Nearest reads `upper` alone.
  struct Four {
    alignas(64) Indices upper;  ///< of the left texel; the right one follows it
    alignas(64) Indices lower;
    alignas(64) Numbers x, y;  ///< weights of the right and of the lower texels
  };

  std::size_t vectors = 0;
  alignas(64) Numbers u, v, level;
  std::array<M, most_vectors> seen;  ///< lanes with a fragment
  Four near, far;
  alignas(64) Numbers between;               ///< weight of `far`
  std::array<bool, most_vectors> needs_far;  ///< whether some fragment's weight is not null
  alignas(64) Numbers red, green, blue;      ///< the result
};

struct Colour {
  V red, green, blue;
};
HWY_INLINE void store(const Colour& colour, std::size_t at, Lookups& run) {
  const D d;
  hn::Store(colour.red, d, run.red.data() + at);
  hn::Store(colour.green, d, run.green.data() + at);
  hn::Store(colour.blue, d, run.blue.data() + at);
}

// Texels of four floats: the channels are read at once, for gathering single ones takes longer, and several fragments
// are mixed at once, a quarter of a vector for each: those of lanes k, k + 4, and so on.
using Quarter = hn::FixedTag<float, 4>;

/// mix_texels()
HWY_INLINE V mix(V a, V b, V f) { return hn::Add(hn::Mul(a, hn::Sub(number(1), f)), hn::Mul(b, f)); }
HWY_INLINE Colour mix(const Colour& a, const Colour& b, V f) {
  return {mix(a.red, b.red, f), mix(a.green, b.green, f), mix(a.blue, b.blue, f)};
}

class FourOfFloats {
 public:
  HWY_INLINE FourOfFloats(const PackedTexture& texture, const Lookups::Four& four, std::size_t at)
      : texels_(texture.texels.data()), upper_(four.upper.data() + at), lower_(four.lower.data() + at),
        x_(hn::Load(D(), four.x.data() + at)), y_(hn::Load(D(), four.y.data() + at)) {}

  /// The colours of the fragments in lanes k, k + 4, ...
#if HWY_MAX_BYTES == 16
  template <int k>
  HWY_INLINE V operator()(std::integral_constant<int, k>) const {
    const auto column = [&](const float* texels) HWY_ATTR {
      return mix(hn::LoadU(D(), texels + upper_[k]), hn::LoadU(D(), texels + lower_[k]), hn::Broadcast<k>(y_));
    };
    return mix(column(texels_), column(texels_ + 4), hn::Broadcast<k>(x_));
  }
#else
  template <int k>
  HWY_INLINE V operator()(std::integral_constant<int, k>) const {
    const V y = hn::Broadcast<k>(y_), turned = hn::SwapAdjacentBlocks(y);
    const V a = mix_columns(k, hn::OddEvenBlocks(turned, y));
    const V b = mix_columns(k + 4, hn::OddEvenBlocks(y, turned));
    const V left = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a);
    const V right = hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a));
    return mix(left, right, hn::Broadcast<k>(x_));
  }
#endif

 private:
#if HWY_MAX_BYTES > 16
  /// Left and right texels lie side by side, and so do their mixtures with those below: of the fragments in lanes
  /// first, first + 8, ...
  HWY_INLINE V mix_columns(std::size_t first, V y) const { return mix(row(upper_ + first), row(lower_ + first), y); }
  HWY_INLINE V row(const std::int32_t* index) const {
    const hn::FixedTag<float, 8> two;
#if HWY_MAX_BYTES == 32
    return hn::LoadU(two, texels_ + index[0]);
#else
    return hn::Combine(D(), hn::LoadU(two, texels_ + index[8]), hn::LoadU(two, texels_ + index[0]));
#endif
  }
#endif

  const float* texels_;
  const std::int32_t *upper_, *lower_;
  V x_, y_;
};

/// A fragment's colour on two levels, mixed.
struct TwoLevels {
  FourOfFloats near, far;
  V between;  ///< weight of `far`

  template <int k>
  HWY_INLINE V operator()(std::integral_constant<int, k> lanes) const {
    return mix(near(lanes), far(lanes), hn::Broadcast<k>(between));
  }
};
/// The same where the weight of `far` may be 0 and its texel NaN.
struct OneOrTwoLevels {
  TwoLevels levels;

  template <int k>
  HWY_INLINE V operator()(std::integral_constant<int, k> lanes) const {
    const M mixed = hn::Gt(hn::Broadcast<k>(levels.between), hn::Zero(D()));
    return hn::IfThenElse(mixed, levels(lanes), levels.near(lanes));
  }
};

/// The first three numbers that make(k) gives for lanes k, k + 4, ...
template <class Make>
HWY_INLINE Colour by_quarters(Make&& make) {
  const auto colour = ps::HWY_NAMESPACE::four_vectors_of_quarters(make);
  return {colour.first, colour.second, colour.third};
}

// Texels of one number, PackedTexture::bytes: a vector for each channel from the beginning.

/// part_of_255() of each byte.
HWY_INLINE Colour unpack(VI bytes) {
  const D d;
  const DI di;
  const auto channel = [&](VI shifted) HWY_ATTR {
    const V level = hn::ConvertTo(d, hn::And(shifted, hn::Set(di, 255)));
    return hn::Add(hn::Mul(level, number(byte_unit[0])), hn::Mul(level, number(byte_unit[1])));
  };
  return {channel(bytes), channel(hn::ShiftRight<8>(bytes)), channel(hn::ShiftRight<16>(bytes))};
}

/// The texels at two indices, each with the one that follows it, side by side.
HWY_INLINE hn::Vec<Quarter> read_two_pairs(const std::uint32_t* texels, const std::int32_t* index) {
  const hn::FixedTag<std::uint32_t, 2> pair;
  const hn::FixedTag<std::uint32_t, 4> two;
  return hn::BitCast(Quarter(),
                     hn::Combine(two, hn::LoadU(pair, texels + index[1]), hn::LoadU(pair, texels + index[0])));
}
/// The same for lanes 0, 1, 4, 5, ... of the numbers at `index`.
HWY_INLINE V read_pairs(const std::uint32_t* texels, const std::int32_t* index) {
  const auto low = read_two_pairs(texels, index);
#if HWY_MAX_BYTES == 16
  return low;
#else
  const hn::FixedTag<float, 8> half;
  const auto first = hn::Combine(half, read_two_pairs(texels, index + 4), low);
#if HWY_MAX_BYTES == 32
  return first;
#else
  return hn::Combine(D(), hn::Combine(half, read_two_pairs(texels, index + 12), read_two_pairs(texels, index + 8)),
                     first);
#endif
#endif
}

/// The texels at each index, and those that follow them.
struct Neighbours {
  VI left, right;
};
HWY_INLINE Neighbours read_neighbours(const std::uint32_t* texels, const std::int32_t* index) {
  const DI di;
  const V a = read_pairs(texels, index), b = read_pairs(texels, index + 2);
  const V even = hn::InterleaveLower(D(), a, b), odd = hn::InterleaveUpper(D(), a, b);
  return {hn::BitCast(di, hn::InterleaveLower(D(), even, odd)), hn::BitCast(di, hn::InterleaveUpper(D(), even, odd))};
}

HWY_INLINE Colour read_four_of_bytes(const PackedTexture& texture, const Lookups::Four& four, std::size_t at) {
  const Neighbours upper = read_neighbours(texture.bytes.data(), four.upper.data() + at);
  const Neighbours lower = read_neighbours(texture.bytes.data(), four.lower.data() + at);
  const V x = hn::Load(D(), four.x.data() + at), y = hn::Load(D(), four.y.data() + at);
  return mix(mix(unpack(upper.left), unpack(lower.left), y), mix(unpack(upper.right), unpack(lower.right), y), x);
}

HWY_INLINE void read_nearest(const PackedTexture& texture, Lookups& run) {
  const DI di;
  const std::size_t end = run.vectors * hn::Lanes(D());
  std::int32_t* const index = run.near.upper.data();
  if (texture.bytes.empty()) {
    for (std::size_t at = 0; at < end; at += hn::Lanes(D()))
      store(by_quarters([&](auto k) HWY_ATTR {
              return ps::HWY_NAMESPACE::every_fourth(
                  [&](std::size_t i) HWY_ATTR { return hn::LoadU(Quarter(), texture.texels.data() + index[at + i]); },
                  k);
            }),
            at, run);
    return;
  }
  // All first, for a vector read from numbers just written would wait until they reach the cache.
  for (std::size_t i = 0; i < end; ++i)
    index[i] = static_cast<std::int32_t>(texture.bytes[static_cast<std::size_t>(index[i])]);
  for (std::size_t at = 0; at < end; at += hn::Lanes(D())) store(unpack(hn::Load(di, index + at)), at, run);
}

HWY_INLINE void read_bilinear(const PackedTexture& texture, Lookups& run) {
  const std::size_t end = run.vectors * hn::Lanes(D());
  if (!texture.bytes.empty()) {
    for (std::size_t at = 0; at < end; at += hn::Lanes(D())) store(read_four_of_bytes(texture, run.near, at), at, run);
    return;
  }
  for (std::size_t at = 0; at < end; at += hn::Lanes(D())) {
    store(by_quarters(FourOfFloats(texture, run.near, at)), at, run);
  }
}

HWY_INLINE void read_trilinear(const PackedTexture& texture, Lookups& run) {
  const D d;
  for (std::size_t i = 0, at = 0; i < run.vectors; ++i, at += hn::Lanes(d)) {
    if (!texture.bytes.empty()) {  // of a single level
      store(read_four_of_bytes(texture, run.near, at), at, run);
      continue;
    }
    const FourOfFloats near(texture, run.near, at);
    if (!run.needs_far[i]) {
      store(by_quarters(near), at, run);
      continue;
    }
    const TwoLevels levels{near, FourOfFloats(texture, run.far, at), hn::Load(d, run.between.data() + at)};
    const M mixed = hn::Gt(levels.between, hn::Zero(d));
    if (hn::AllFalse(d, hn::AndNot(mixed, run.seen[i])))
      store(by_quarters(levels), at, run);
    else
      store(by_quarters(OneOrTwoLevels{levels}), at, run);
  }
}

}  // namespace texture
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
