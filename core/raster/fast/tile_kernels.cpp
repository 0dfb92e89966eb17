#include <algorithm>
#include <cstdlib>
#include <limits>

#include "options/simd_choice.h"
#include "raster/fast/tile.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/tile_kernels.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Edge values as 32-bit integers, for small triangles.
struct Small {
  using D = hn::CappedTag<float, 8>;
  using Count = hn::Rebind<std::int32_t, D>;
  using Scalar = std::int32_t;
  using Value = hn::Vec<Count>;
  static HWY_INLINE hn::Mask<D> above(Value value, Value threshold) {
    return hn::RebindMask(D(), hn::Gt(value, threshold));
  }
  static HWY_INLINE hn::Vec<D> to_float(Value value) { return hn::ConvertTo(D(), value); }
};

/// Edge values as doubles, which hold integers below 2^53 exactly and round once on their way to float, as a 64-bit
/// integer does.
struct Large {
  using Count = hn::ScalableTag<double>;
  using D = hn::Rebind<float, Count>;
  using Scalar = double;
  using Value = hn::Vec<Count>;
  static HWY_INLINE hn::Mask<D> above(Value value, Value threshold) {
    const Value flag = hn::IfThenElseZero(hn::Gt(value, threshold), hn::Set(Count(), 1.0));
    return hn::Gt(hn::DemoteTo(D(), flag), hn::Zero(D()));
  }
  static HWY_INLINE hn::Vec<D> to_float(Value value) { return hn::DemoteTo(D(), value); }
};

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
    replaced.push_back({{tile.weights[0][i], tile.weights[1][i], tile.weights[2][i]}, tile.inverse_z[i], tile.id[i]});
  }
}

/// Draws the box; how many fragments passed the depth test.
template <class Kind>
HWY_INLINE std::uint64_t cover_box(const BoxEdges<typename Kind::Scalar>& edges, std::uint32_t id,
                                   TileFragments& tile) {
  using Value = typename Kind::Value;
  using D = typename Kind::D;
  using V = hn::Vec<D>;
  const D d;
  const typename Kind::Count dc;
  const hn::Rebind<std::uint32_t, D> du;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto set = [&](typename Kind::Scalar value) HWY_ATTR { return hn::Set(dc, value); };
  const Value ramp = hn::Iota(dc, 0);
  const Value spread0 = hn::Mul(ramp, set(edges.step_x[0])), spread1 = hn::Mul(ramp, set(edges.step_x[1])),
              spread2 = hn::Mul(ramp, set(edges.step_x[2]));
  const auto stride = static_cast<typename Kind::Scalar>(lanes);
  const Value stride0 = set(edges.step_x[0] * stride), stride1 = set(edges.step_x[1] * stride),
              stride2 = set(edges.step_x[2] * stride);
  const Value threshold0 = set(edges.threshold[0]), threshold1 = set(edges.threshold[1]),
              threshold2 = set(edges.threshold[2]);
  const V inverse_area = hn::Set(d, edges.inverse_area);
  const V inverse_z0 = hn::Set(d, edges.inverse_z[0]), inverse_z1 = hn::Set(d, edges.inverse_z[1]),
          inverse_z2 = hn::Set(d, edges.inverse_z[2]);
  const auto ids = hn::Set(du, id);
  std::uint64_t passes = 0, covered = 0;
  std::array<typename Kind::Scalar, 3> start = edges.value;
  for (int y = 0; y < edges.height; ++y) {
    Value value0 = hn::Add(set(start[0]), spread0), value1 = hn::Add(set(start[1]), spread1),
          value2 = hn::Add(set(start[2]), spread2);
    std::size_t at = static_cast<std::size_t>(edges.y + y) * fast_tile + static_cast<std::size_t>(edges.x);
    for (int x = 0; x < edges.width; x += lanes, at += static_cast<std::size_t>(lanes)) {
      const auto inside =
          hn::And(hn::And(Kind::above(value0, threshold0), Kind::above(value1, threshold1)),
                  hn::And(Kind::above(value2, threshold2), hn::FirstN(d, static_cast<std::size_t>(edges.width - x))));
      if (!hn::AllFalse(d, inside)) {
        covered += hn::CountTrue(d, inside);
        const V weight0 = hn::Mul(Kind::to_float(value0), inverse_area);
        const V weight1 = hn::Mul(Kind::to_float(value1), inverse_area);
        const V weight2 = hn::Mul(Kind::to_float(value2), inverse_area);
        const V inverse_z =
            hn::Add(hn::Add(hn::Mul(weight0, inverse_z0), hn::Mul(weight1, inverse_z1)), hn::Mul(weight2, inverse_z2));
        float* depth = tile.inverse_z.data() + at;
        const auto passed = hn::And(inside, hn::Gt(inverse_z, hn::LoadU(d, depth)));
        if (!hn::AllFalse(d, passed)) {
          passes += hn::CountTrue(d, passed);
          if (tile.keep_replaced) {
            std::array<std::uint8_t, 8> bits{};
            hn::StoreMaskBits(d, passed, bits.data());
            keep_replaced(tile, at, bits[0], tile.replaced);
          }
          hn::BlendedStore(inverse_z, passed, d, depth);
          hn::BlendedStore(weight0, passed, d, tile.weights[0].data() + at);
          hn::BlendedStore(weight1, passed, d, tile.weights[1].data() + at);
          hn::BlendedStore(weight2, passed, d, tile.weights[2].data() + at);
          hn::BlendedStore(ids, hn::RebindMask(du, passed), du, tile.id.data() + at);
        }
      }
      value0 = hn::Add(value0, stride0);
      value1 = hn::Add(value1, stride1);
      value2 = hn::Add(value2, stride2);
    }
    for (std::size_t i = 0; i < 3; ++i) start[i] += edges.step_y[i];
  }
  tile.fragments += covered;
  return passes;
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
      for (std::size_t i = 0; i < 3; ++i) tile.weights[i][at] = weights[i];
      tile.id[at] = id;
    }
  return passes;
}

PixelBox common(const PixelBox& box, const TileRect& rect) {
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
  return cover_box<Small>(edges, id, tile);
}

std::uint64_t cover_general(const CoverageGrid& grid, const ScreenTriangle<float>& triangle, const TileRect& rect,
                            std::uint32_t id, TileFragments& tile) {
  const TriangleEdges exact = *make_edges(triangle.corners, grid);
  const PixelBox box = common(triangle.box, rect);
  BoxEdges<std::int64_t> edges;
  place(box, rect, edges);
  edges.inverse_area = 1.0f / static_cast<float>(exact.area);
  edges.inverse_z = triangle.inverse_z.data();
  edges.value = exact.at(box.x0, box.y0);
  edges.step_x = exact.step_x;
  edges.step_y = exact.step_y;
  edges.threshold = exact.threshold;
  bool fits = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto within = [](std::int64_t v, int bits) { return std::abs(v) <= std::int64_t{1} << bits; };
    fits = fits && within(edges.value[i], 51) && within(edges.step_x[i], 43) && within(edges.step_y[i], 43);
  }
  if (!fits) return cover_exactly(edges, id, tile);
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
  return cover_box<Large>(wide, id, tile);
}

}  // namespace

void cover(const CoverageGrid& grid, const TileRect& rect, const FastPart& part, std::span<const std::uint32_t> entries,
           TileFragments& tile) {
  for (const std::uint32_t entry : entries) {
    const FastTriangle& triangle = part.triangles[entry];
    const std::uint32_t id = tile.triangle_count;
    const std::uint64_t passed = triangle.is_general()
                                     ? cover_general(grid, part.cut.triangles[triangle.triangle], rect, id, tile)
                                     : cover_small(triangle, rect, id, tile);
    tile.passed[triangle.surface] += passed;
    tile.triangles[id] = {&triangle, &part};
    tile.triangle_count += passed > 0;
  }
}

void collect(const TileFragments& tile, const TileRect& rect, int row, const Vec3f& background, Vec3f* pixels,
             int width, ShadeBatch& batch) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const std::size_t lanes = hn::Lanes(d);
  const auto none = hn::Set(di, static_cast<std::int32_t>(TileFragments::none));
  const std::size_t first = static_cast<std::size_t>(row - rect.y0) * fast_tile;
  const auto wide = static_cast<std::size_t>(rect.width());
  const std::int32_t first_pixel = row * width + rect.x0;
  for (std::size_t x = 0; x < wide; x += lanes) {
    const auto inside = hn::FirstN(di, wide - x);
    const auto ids = hn::BitCast(di, hn::LoadU(hn::Rebind<std::uint32_t, decltype(d)>(), tile.id.data() + first + x));
    const auto seen = hn::AndNot(hn::Eq(ids, none), inside);
    const std::size_t count = hn::CountTrue(di, seen);
    if (count < std::min(lanes, wide - x))
      std::fill_n(pixels + first_pixel + static_cast<std::ptrdiff_t>(x), std::min(lanes, wide - x), background);
    if (count == 0) continue;
    const auto at = static_cast<std::size_t>(batch.count);
    const auto seen_float = hn::RebindMask(d, seen);
    const auto numbers = hn::Iota(di, first_pixel + static_cast<std::int32_t>(x));
    const auto z = hn::Div(hn::Set(d, 1.0f), hn::LoadU(d, tile.inverse_z.data() + first + x));
    const bool all = count == lanes;
    hn::StoreU(all ? numbers : hn::Compress(numbers, seen), di, batch.pixels.data() + at);
    hn::StoreU(all ? ids : hn::Compress(ids, seen), di, batch.rows.data() + at);
    hn::StoreU(all ? z : hn::Compress(z, seen_float), d, batch.z.data() + at);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto weight = hn::LoadU(d, tile.weights[i].data() + first + x);
      hn::StoreU(all ? weight : hn::Compress(weight, seen_float), d, batch.weights[i].data() + at);
    }
    batch.count += static_cast<int>(count);
  }
}

bool write(const ShadeBatch& batch, Vec3f* pixels) {
  const hn::ScalableTag<float> d;
  const std::size_t lanes = hn::Lanes(d);
  const auto count = static_cast<std::size_t>(batch.count);
  bool nan = false;
  for (std::size_t i = 0; i < count; i += lanes) {
    const auto red = hn::LoadU(d, batch.red.data() + i), green = hn::LoadU(d, batch.green.data() + i),
               blue = hn::LoadU(d, batch.blue.data() + i);
    const std::size_t here = std::min(lanes, count - i);
    const auto bad = hn::Or(hn::Or(hn::Ne(red, red), hn::Ne(green, green)), hn::Ne(blue, blue));
    nan = nan || !hn::AllFalse(d, hn::And(bad, hn::FirstN(d, here)));
    if (here == lanes && batch.pixels[i + lanes - 1] - batch.pixels[i] == static_cast<std::int32_t>(lanes) - 1) {
      hn::StoreInterleaved3(red, green, blue, d, &pixels[batch.pixels[i]].x);
    } else {
      for (std::size_t k = i; k < i + here; ++k)
        pixels[batch.pixels[k]] = Vec3f(batch.red[k], batch.green[k], batch.blue[k]);
    }
  }
  return nan;
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

TileKernels tile_kernels(Simd simd) {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  if (may_use(simd, Simd::avx512, have, HWY_AVX3)) return {N_AVX3::cover, N_AVX3::collect, N_AVX3::write};
  if (may_use(simd, Simd::avx2, have, HWY_AVX2)) return {N_AVX2::cover, N_AVX2::collect, N_AVX2::write};
  if (may_use(simd, Simd::sse4, have, HWY_SSE4)) return {N_SSE4::cover, N_SSE4::collect, N_SSE4::write};
#else
  static_cast<void>(simd);
#endif
  return {};
}

}  // namespace ps::raster
#endif
