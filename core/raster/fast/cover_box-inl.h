// Coverage and depth of one triangle's box in a tile; compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_FAST_COVER_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_FAST_COVER_BOX_INL_H_
#undef PIXELSCOPE_FAST_COVER_BOX_INL_H_
#else
#define PIXELSCOPE_FAST_COVER_BOX_INL_H_
#endif

#include <algorithm>

#include "hwy/highway.h"
#include "math/mask_bits-inl.h"
#include "raster/fast/tile.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace covering {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

/// Edge values as 32-bit integers, for small triangles.
struct Small {
  using Count = hn::Rebind<std::int32_t, D>;
  using Scalar = std::int32_t;
  using Value = hn::Vec<Count>;
  static HWY_INLINE Value from(Scalar first, Scalar step, int before) {
    return hn::Add(hn::Set(Count(), first + before * step), hn::Mul(hn::Iota(Count(), 0), hn::Set(Count(), step)));
  }
  static HWY_INLINE Value same(Scalar value) { return hn::Set(Count(), value); }
  static HWY_INLINE void add(Value& value, const Value& more) { value = hn::Add(value, more); }
  static HWY_INLINE V to_float(const Value& value) { return hn::ConvertTo(D(), value); }
  static HWY_INLINE M above(const Value& value, V, std::int32_t threshold) {
    return hn::RebindMask(D(), hn::Gt(value, hn::Set(Count(), threshold)));
  }
};

/// Edge values as doubles, which hold integers below 2^53 exactly and round once on their way to float, as a 64-bit
/// integer does. Rounded, an integer is above 0, or above -1, where it was before.
struct Large {
  using Half = hn::Half<D>;
  using Count = hn::Rebind<double, Half>;
  using Scalar = double;
  struct Value {
    hn::Vec<Count> low, high;
  };
  static HWY_INLINE Value from(Scalar first, Scalar step, int before) {
    const auto change = hn::Set(Count(), step);
    const auto low = hn::Add(hn::Set(Count(), first + before * step), hn::Mul(hn::Iota(Count(), 0.0), change));
    return {low, hn::Add(low, hn::Mul(hn::Set(Count(), static_cast<double>(hn::Lanes(Count()))), change))};
  }
  static HWY_INLINE Value same(Scalar value) { return {hn::Set(Count(), value), hn::Set(Count(), value)}; }
  static HWY_INLINE void add(Value& value, const Value& more) {
    value = {hn::Add(value.low, more.low), hn::Add(value.high, more.high)};
  }
  static HWY_INLINE V to_float(const Value& value) {
    return hn::Combine(D(), hn::DemoteTo(Half(), value.high), hn::DemoteTo(Half(), value.low));
  }
  static HWY_INLINE M above(const Value&, V rounded, double threshold) {
    return hn::Gt(rounded, hn::Set(D(), static_cast<float>(threshold)));
  }
};

/// Whether all samples of a box are known to lie inside.
enum class Covers { some, all };

/// What to do with a vector none of whose samples lies inside. To go on costs little; a branch that cannot be foreseen
/// costs more.
enum class WhenOutside { skip, go_on };

/// What becomes of a fragment that a nearer one replaces.
enum class Replaced { forgotten, kept };

/// A triangle's edges as `Kind` counts them, from the first sample of `box` on.
template <class Scalar>
struct BoxEdges {
  std::array<Scalar, 3> value{}, step_x{}, step_y{}, threshold{};
  float inverse_area = 0;
  const float* inverse_z = nullptr;
  int x = 0, y = 0;  ///< of the box, in the tile
  int width = 0, height = 0;
};

HWY_INLINE void keep_replaced(const TileFragments& tile, std::size_t at, std::uint64_t lanes,
                              std::vector<ReplacedFragment>& replaced) {
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::size_t i = at + hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes);
    if (tile.id[i] == TileFragments::none) continue;
    replaced.push_back({tile.inverse_z[i], tile.id[i], static_cast<std::uint32_t>(i)});
  }
}

/// The fragments of one vector: those that pass the depth test replace what was there. How many do. Whether any does
/// cannot be foreseen, so there is no branch on it.
template <Replaced replaced>
HWY_INLINE std::uint64_t put(M inside, V inverse_z, std::uint32_t id, std::size_t at, TileFragments& tile) {
  const D d;
  const hn::Rebind<std::uint32_t, D> du;
  float* const depth = tile.inverse_z.data() + at;
  const V before = hn::Load(d, depth);
  const M passed = hn::And(inside, hn::Gt(inverse_z, before));
  std::uint32_t* const id_at = tile.id.data() + at;
  const auto id_before = hn::Load(du, id_at);
  if constexpr (replaced == Replaced::kept) {
    const M shown = hn::RebindMask(d, hn::Ne(id_before, hn::Set(du, TileFragments::none)));
    keep_replaced(tile, at, ps::HWY_NAMESPACE::bits_of(d, hn::And(passed, shown)), tile.replaced);
  }
  hn::Store(hn::IfThenElse(passed, inverse_z, before), d, depth);
  hn::Store(hn::IfThenElse(hn::RebindMask(du, passed), hn::Set(du, id), id_before), du, id_at);
  return hn::CountTrue(d, passed);
}

/// Draws the vectors of a box, and counts.
template <class Kind, Replaced replaced>
class BoxVectors {
 public:
  using Value = typename Kind::Value;
  using Scalar = typename Kind::Scalar;
  HWY_INLINE BoxVectors(const BoxEdges<Scalar>& edges, std::uint32_t id, TileFragments& tile)
      : edges_(edges), tile_(tile), id_(id),
        inverse_area_(hn::Set(D(), edges.inverse_area)), inverse_z_{hn::Set(D(), edges.inverse_z[0]),
                                                                    hn::Set(D(), edges.inverse_z[1]),
                                                                    hn::Set(D(), edges.inverse_z[2])} {}

  /// The edges' values in the box's first row, at the vector that begins `before` samples ahead of it.
  HWY_INLINE std::array<Value, 3> first_row(int before) const {
    std::array<Value, 3> row;
    for (std::size_t i = 0; i < 3; ++i) row[i] = Kind::from(edges_.value[i], edges_.step_x[i], before);
    return row;
  }
  template <Covers covers, WhenOutside when_outside>
  HWY_INLINE void draw(const std::array<Value, 3>& value, M inside, std::size_t at) {
    const D d;
    std::array<V, 3> weight;
    for (std::size_t i = 0; i < 3; ++i) {
      weight[i] = Kind::to_float(value[i]);
      if constexpr (covers == Covers::some)
        inside = hn::And(inside, Kind::above(value[i], weight[i], edges_.threshold[i]));
    }
    if (covers == Covers::some && when_outside == WhenOutside::skip && hn::AllFalse(d, inside)) return;
    covered += hn::CountTrue(d, inside);
    for (std::size_t i = 0; i < 3; ++i) weight[i] = hn::Mul(weight[i], inverse_area_);
    const V inverse_z = hn::Add(hn::Add(hn::Mul(weight[0], inverse_z_[0]), hn::Mul(weight[1], inverse_z_[1])),
                                hn::Mul(weight[2], inverse_z_[2]));
    passed += put<replaced>(inside, inverse_z, id_, at, tile_);
  }
  std::uint64_t passed = 0, covered = 0;

 private:
  const BoxEdges<Scalar>& edges_;
  TileFragments& tile_;
  std::uint32_t id_;
  V inverse_area_;
  std::array<V, 3> inverse_z_;
};

/// Draws the box; how many fragments passed the depth test. Vectors lie where their length divides their place in the
/// row, and are written as a whole: what the next triangle reads there is then known before it has left the processor.
template <class Kind, Covers covers, Replaced replaced>
HWY_INLINE std::uint64_t cover_box(const BoxEdges<typename Kind::Scalar>& edges, std::uint32_t id,
                                   TileFragments& tile) {
  using Scalar = typename Kind::Scalar;
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = edges.x & ~(lanes - 1), end = edges.x + edges.width;
  BoxVectors<Kind, replaced> vectors(edges, id, tile);
  auto row = vectors.first_row(begin - edges.x);
  std::array<typename Kind::Value, 3> down, stride;
  for (std::size_t i = 0; i < 3; ++i) {
    down[i] = Kind::same(edges.step_y[i]);
    stride[i] = Kind::same(edges.step_x[i] * static_cast<Scalar>(lanes));
  }
  const M last = hn::FirstN(d, static_cast<std::size_t>((end - begin - 1) % lanes + 1)),
          all = hn::FirstN(d, hn::Lanes(d));
  std::size_t at_row = static_cast<std::size_t>(edges.y) * fast_tile + static_cast<std::size_t>(begin);
  for (int y = 0; y < edges.height; ++y, at_row += fast_tile) {
    auto value = row;
    std::size_t at = at_row;
    for (int x = begin; x < end; x += lanes, at += static_cast<std::size_t>(lanes)) {
      vectors.template draw<covers, WhenOutside::skip>(value, end - x <= lanes ? last : all, at);
      for (std::size_t i = 0; i < 3; ++i) Kind::add(value[i], stride[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) Kind::add(row[i], down[i]);
  }
  tile.fragments += vectors.covered;
  return vectors.passed;
}

/// The same for a box of one or two vectors in each row, one below the other: without branches that a processor cannot
/// foresee.
template <Replaced replaced>
HWY_INLINE std::uint64_t cover_narrow_box(const BoxEdges<std::int32_t>& edges, std::uint32_t id, TileFragments& tile) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = edges.x & ~(lanes - 1), end = edges.x + edges.width;
  BoxVectors<Small, replaced> vectors(edges, id, tile);
  std::array<Small::Value, 3> down;
  for (std::size_t i = 0; i < 3; ++i) down[i] = Small::same(edges.step_y[i]);
  for (int x = begin; x < end; x += lanes) {
    auto value = vectors.first_row(x - edges.x);
    const M inside = hn::FirstN(d, static_cast<std::size_t>(std::min(end - x, lanes)));
    std::size_t at = static_cast<std::size_t>(edges.y) * fast_tile + static_cast<std::size_t>(x);
    for (int y = 0; y < edges.height; ++y, at += fast_tile) {
      vectors.template draw<Covers::some, WhenOutside::go_on>(value, inside, at);
      for (std::size_t i = 0; i < 3; ++i) Small::add(value[i], down[i]);
    }
  }
  tile.fragments += vectors.covered;
  return vectors.passed;
}

/// What is known of a box from its corners: all its samples lie inside the three edges, or all lie outside one of them.
enum class BoxLies { inside, across, outside };
template <class Scalar>
HWY_INLINE BoxLies place_of_box(const BoxEdges<Scalar>& edges) {
  const Scalar across = static_cast<Scalar>(edges.width - 1), down = static_cast<Scalar>(edges.height - 1);
  BoxLies lies = BoxLies::inside;
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar x = edges.step_x[i] * across, y = edges.step_y[i] * down, zero{0};
    const Scalar least = edges.value[i] + std::min(x, zero) + std::min(y, zero);
    const Scalar most = edges.value[i] + std::max(x, zero) + std::max(y, zero);
    if (!(most > edges.threshold[i])) return BoxLies::outside;
    if (!(least > edges.threshold[i])) lies = BoxLies::across;
  }
  return lies;
}

}  // namespace covering
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
