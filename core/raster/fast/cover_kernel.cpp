#include <algorithm>
#include <limits>

#include "options/simd_choice.h"
#include "raster/fast/tile.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/cover_kernel.cpp"
#include "hwy/cache_control.h"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

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
HWY_INLINE std::uint64_t put(M inside, V inverse_z, std::uint32_t id, std::size_t at, TileFragments& tile) {
  const D d;
  const hn::Rebind<std::uint32_t, D> du;
  float* const depth = tile.inverse_z.data() + at;
  const V before = hn::Load(d, depth);
  const M passed = hn::And(inside, hn::Gt(inverse_z, before));
  std::uint32_t* const id_at = tile.id.data() + at;
  const auto id_before = hn::Load(du, id_at);
  if (tile.keep_replaced) {
    const M shown = hn::RebindMask(d, hn::Ne(id_before, hn::Set(du, TileFragments::none)));
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, hn::And(passed, shown), bits.data());
    keep_replaced(tile, at, bits[0] | std::uint64_t{bits[1]} << 8, tile.replaced);
  }
  hn::Store(hn::IfThenElse(passed, inverse_z, before), d, depth);
  hn::Store(hn::IfThenElse(hn::RebindMask(du, passed), hn::Set(du, id), id_before), du, id_at);
  return hn::CountTrue(d, passed);
}

/// Draws the vectors of a box, and counts.
template <class Kind>
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
    passed += put(inside, inverse_z, id_, at, tile_);
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
template <class Kind, Covers covers>
HWY_INLINE std::uint64_t cover_box(const BoxEdges<typename Kind::Scalar>& edges, std::uint32_t id,
                                   TileFragments& tile) {
  using Scalar = typename Kind::Scalar;
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = edges.x & ~(lanes - 1), end = edges.x + edges.width;
  BoxVectors<Kind> vectors(edges, id, tile);
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
HWY_INLINE std::uint64_t cover_narrow_box(const BoxEdges<std::int32_t>& edges, std::uint32_t id, TileFragments& tile) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = edges.x & ~(lanes - 1), end = edges.x + edges.width;
  BoxVectors<Small> vectors(edges, id, tile);
  std::array<Small::Value, 3> down;
  for (std::size_t i = 0; i < 3; ++i) down[i] = Small::same(edges.step_y[i]);
  for (int x = begin; x < end; x += lanes) {
    auto value = vectors.first_row(x - edges.x);
    const M inside = hn::FirstN(d, static_cast<std::size_t>(std::min(end - x, lanes)));
    std::size_t at = static_cast<std::size_t>(edges.y) * fast_tile + static_cast<std::size_t>(x);
    for (int y = 0; y < edges.height; ++y, at += fast_tile) {
      vectors.draw<Covers::some, WhenOutside::go_on>(value, inside, at);
      for (std::size_t i = 0; i < 3; ++i) Small::add(value[i], down[i]);
    }
  }
  tile.fragments += vectors.covered;
  return vectors.passed;
}

/// Whether the corners of a box, and so all its samples, lie inside the three edges.
template <class Scalar>
HWY_INLINE bool covers_corners(const BoxEdges<Scalar>& edges) {
  const Scalar across = static_cast<Scalar>(edges.width - 1), down = static_cast<Scalar>(edges.height - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar least =
        edges.value[i] + std::min(edges.step_x[i] * across, Scalar{0}) + std::min(edges.step_y[i] * down, Scalar{0});
    if (!(least > edges.threshold[i])) return false;
  }
  return true;
}

/// Without vectors: edges whose values double may not hold.
std::uint64_t cover_exactly(const BoxEdges<std::int64_t>& edges, std::uint32_t id, TileFragments& tile) {
  std::uint64_t passes = 0;
  for (int y = 0; y < edges.height; ++y)
    for (int x = 0; x < edges.width; ++x) {
      std::array<float, 3> weights;
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t value = edges.value[i] + edges.step_x[i] * x + edges.step_y[i] * y;
        inside = inside && value > edges.threshold[i];
        weights[i] = static_cast<float>(value) * edges.inverse_area;
      }
      if (!inside) continue;
      ++tile.fragments;
      const float inverse_z =
          weights[0] * edges.inverse_z[0] + weights[1] * edges.inverse_z[1] + weights[2] * edges.inverse_z[2];
      const std::size_t at = static_cast<std::size_t>(edges.y + y) * fast_tile + static_cast<std::size_t>(edges.x + x);
      if (!(inverse_z > tile.inverse_z[at])) continue;
      ++passes;
      if (tile.keep_replaced) keep_replaced(tile, at, 1, tile.replaced);
      tile.inverse_z[at] = inverse_z;
      tile.id[at] = id;
    }
  return passes;
}

HWY_INLINE PixelBox common(const PixelBox& box, const TileRect& rect) {
  return {std::max(box.x0, rect.x0), std::max(box.y0, rect.y0), std::min(box.x1, rect.x1), std::min(box.y1, rect.y1)};
}

template <class Scalar>
void place(const PixelBox& box, const TileRect& rect, BoxEdges<Scalar>& edges) {
  edges.x = box.x0 - rect.x0;
  edges.y = box.y0 - rect.y0;
  edges.width = box.x1 - box.x0;
  edges.height = box.y1 - box.y0;
}

HWY_INLINE std::uint64_t cover_small(const FastTriangle& triangle, const TileRect& rect, std::uint32_t id,
                                     TileFragments& tile) {
  const PixelBox whole = triangle.box();
  const PixelBox box = common(whole, rect);
  const std::int32_t dx = box.x0 - whole.x0, dy = box.y0 - whole.y0;
  BoxEdges<std::int32_t> edges;
  place(box, rect, edges);
  edges.inverse_area = triangle.inverse_area;
  edges.inverse_z = triangle.inverse_z.data();
  for (std::size_t i = 0; i < 2; ++i) {
    edges.step_x[i] = triangle.step_x[i];
    edges.step_y[i] = triangle.step_y[i];
    edges.value[i] = triangle.value[i] + dx * triangle.step_x[i] + dy * triangle.step_y[i];
  }
  edges.step_x[2] = -triangle.step_x[0] - triangle.step_x[1];
  edges.step_y[2] = -triangle.step_y[0] - triangle.step_y[1];
  edges.value[2] = triangle.area - edges.value[0] - edges.value[1];
  for (std::size_t i = 0; i < 3; ++i) edges.threshold[i] = -static_cast<std::int32_t>(triangle.shape >> (16 + i) & 1);
  constexpr int narrow = 2 * static_cast<int>(hn::MaxLanes(D()));
  const int offset = edges.x & (static_cast<int>(hn::Lanes(D())) - 1);
  if (offset + edges.width <= narrow) return cover_narrow_box(edges, id, tile);
  return cover_box<Small, Covers::some>(edges, id, tile);
}

std::uint64_t cover_large(const LargeTriangle& triangle, const PixelBox& whole, const std::array<float, 3>& inverse_z,
                          const TileRect& rect, std::uint32_t id, TileFragments& tile) {
  const PixelBox box = common(whole, rect);
  BoxEdges<std::int64_t> edges;
  place(box, rect, edges);
  edges.inverse_area = triangle.inverse_area;
  edges.inverse_z = inverse_z.data();
  edges.value = triangle.edges.at(box.x0, box.y0);
  edges.step_x = triangle.edges.step_x;
  edges.step_y = triangle.edges.step_y;
  edges.threshold = triangle.edges.threshold;
  if (!triangle.fits_double) return cover_exactly(edges, id, tile);
  BoxEdges<double> wide;
  place(box, rect, wide);
  wide.inverse_area = edges.inverse_area;
  wide.inverse_z = edges.inverse_z;
  for (std::size_t i = 0; i < 3; ++i) {
    wide.value[i] = static_cast<double>(edges.value[i]);
    wide.step_x[i] = static_cast<double>(edges.step_x[i]);
    wide.step_y[i] = static_cast<double>(edges.step_y[i]);
    wide.threshold[i] = static_cast<double>(edges.threshold[i]);
  }
  const bool at_vector = edges.x % static_cast<int>(hn::Lanes(D())) == 0;
  if (at_vector && covers_corners(edges)) return cover_box<Large, Covers::all>(wide, id, tile);
  return cover_box<Large, Covers::some>(wide, id, tile);
}

}  // namespace

/// A fragment of a tiny triangle. Whether it is the nearest cannot be foreseen, so there is no branch on it.
HWY_INLINE void cover_fragment(const FastFragment& fragment, const FastPart& part, TileFragments& tile) {
  constexpr std::uint32_t in_tile = fast_tile - 1;
  const std::size_t at = (fragment.place >> 16 & in_tile) << fast_tile_bits | (fragment.place & in_tile);
  const float before = tile.inverse_z[at];
  const std::uint32_t id_before = tile.id[at], id = tile.triangle_count;
  const bool passed = fragment.inverse_z > before;
  if (tile.keep_replaced && passed) keep_replaced(tile, at, 1, tile.replaced);
  tile.inverse_z[at] = passed ? fragment.inverse_z : before;
  tile.id[at] = passed ? id : id_before;
  tile.triangles[id] = {nullptr, &fragment, &part};
  tile.triangle_count = id + (passed ? 1 : 0);
  tile.passed[fragment.surface] += passed ? 1 : 0;
  ++tile.fragments;
}

void cover(const TileRect& rect, const FastPart& part, std::span<const std::uint32_t> entries, TileFragments& tile) {
  constexpr std::size_t ahead = 16;
  const auto fetch = [&](std::uint32_t entry) {
    if ((entry & FastPart::fragment) != 0)
      hwy::Prefetch(&part.fragments[entry & ~FastPart::fragment]);
    else
      hwy::Prefetch(&part.triangles[entry]);
  };
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i + ahead < entries.size()) fetch(entries[i + ahead]);
    const std::uint32_t entry = entries[i];
    if ((entry & FastPart::fragment) != 0) {
      cover_fragment(part.fragments[entry & ~FastPart::fragment], part, tile);
      continue;
    }
    const FastTriangle& triangle = part.triangles[entry];
    const std::uint32_t id = tile.triangle_count;
    const std::uint64_t passed =
        triangle.is_general() ? cover_large(part.large[triangle.triangle], part.cut.triangles[triangle.triangle].box,
                                            triangle.inverse_z, rect, id, tile)
                              : cover_small(triangle, rect, id, tile);
    tile.passed[triangle.surface] += passed;
    tile.triangles[id] = {&triangle, nullptr, &part};
    tile.triangle_count += passed > 0;
  }
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

void TileFragments::start(std::size_t entries, std::size_t surfaces) {
  inverse_z.fill(-std::numeric_limits<float>::infinity());
  id.fill(none);
  if (triangles.size() < entries + 1) triangles.resize(entries + 1 + entries / 2);
  triangle_count = 0;
  fragments = 0;
  passed.assign(surfaces, 0);
  replaced.clear();
}

CoverTile cover_kernel(Simd simd) {
#if HWY_ARCH_X86
  const std::int64_t have = processor_targets();
  if (may_use(simd, Simd::avx512, have, HWY_AVX3)) return N_AVX3::cover;
  if (may_use(simd, Simd::avx2, have, HWY_AVX2)) return N_AVX2::cover;
  if (may_use(simd, Simd::sse4, have, HWY_SSE4)) return N_SSE4::cover;
#else
  static_cast<void>(simd);
#endif
  return nullptr;
}

}  // namespace ps::raster
#endif
