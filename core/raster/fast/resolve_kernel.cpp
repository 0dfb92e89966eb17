#include <algorithm>
#include <bit>
#include <cstddef>

#include "options/simd_choice.h"
#include "raster/fast/resolve.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/resolve_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raster/shade_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using shading::D;
using shading::M;
using shading::V;
using shading::V3;
using DI = hn::Rebind<std::int32_t, D>;
using VI = hn::Vec<DI>;
using Four = hn::FixedTag<float, 4>;

constexpr std::size_t most_lanes = hn::MaxLanes(D());

HWY_INLINE std::uint64_t bits_of(M mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(D(), mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < (most_lanes + 7) / 8; ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

HWY_INLINE M mask_of(std::uint64_t bits) {
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < 2; ++i) bytes[i] = static_cast<std::uint8_t>(bits >> (8 * i));
  return hn::LoadMaskBits(D(), bytes.data());
}

/// The lanes of a vector that show one triangle.
struct Share {
  std::uint32_t id = 0;
  std::uint64_t lanes = 0;
  M mask{};
};

/// The fragments of a vector and where they lie.
struct Fragments {
  std::array<Share, most_lanes> shares;
  std::size_t count = 0;  ///< of the shares
  V z, inverse_z;
  alignas(64) std::array<std::int32_t, most_lanes> column{}, row{};  ///< in the picture
  bool in_row = true;                                                ///< columns follow each other
};

/// An edge's values where they fit 32 bits; products may wrap around in lanes that nobody asks for.
HWY_INLINE std::int32_t edge_value(std::int32_t value, std::int32_t step_x, std::int32_t step_y, int dx, int dy) {
  const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
  return static_cast<std::int32_t>(u(value) + u(step_x) * u(dx) + u(step_y) * u(dy));
}

/// The weights of one fragment of a triangle.
HWY_INLINE std::array<float, 3> weights_at(const TileTriangle& triangle, int column, int row) {
  if (!triangle.triangle) return triangle.fragment->weights;
  const FastTriangle& record = *triangle.triangle;
  std::array<float, 3> weights;
  if (record.is_general()) {
    const LargeTriangle& large = triangle.part->large[record.triangle];
    const std::array<std::int64_t, 3> values = large.edges.at(column, row);
    for (std::size_t i = 0; i < 3; ++i) weights[i] = static_cast<float>(values[i]) * large.inverse_area;
    return weights;
  }
  const int dx = column - record.box().x0, dy = row - record.box().y0;
  const std::int32_t first = edge_value(record.value[0], record.step_x[0], record.step_y[0], dx, dy);
  const std::int32_t second = edge_value(record.value[1], record.step_x[1], record.step_y[1], dx, dy);
  return {static_cast<float>(first) * record.inverse_area, static_cast<float>(second) * record.inverse_area,
          static_cast<float>(record.area - first - second) * record.inverse_area};
}

using Weights = std::array<V, 3>;

/// The weights of a triangle at the vector whose first sample is (column, row).
HWY_INLINE Weights small_weights(const FastTriangle& record, int column, int row) {
  const D d;
  const DI di;
  const int dx = column - record.box().x0, dy = row - record.box().y0;
  const auto value = [&](std::size_t i) HWY_ATTR {
    const std::int32_t first = edge_value(record.value[i], record.step_x[i], record.step_y[i], dx, dy);
    return hn::Add(hn::Set(di, first), hn::Mul(hn::Iota(di, 0), hn::Set(di, record.step_x[i])));
  };
  const VI first = value(0), second = value(1);
  const VI third = hn::Sub(hn::Sub(hn::Set(di, record.area), first), second);
  const V inverse_area = hn::Set(d, record.inverse_area);
  return {hn::Mul(hn::ConvertTo(d, first), inverse_area), hn::Mul(hn::ConvertTo(d, second), inverse_area),
          hn::Mul(hn::ConvertTo(d, third), inverse_area)};
}

HWY_INLINE Weights large_weights(const LargeTriangle& large, int column, int row) {
  const D d;
  const hn::Half<D> half;
  const hn::Repartition<double, D> wide;
  const V inverse_area = hn::Set(d, large.inverse_area);
  const std::array<std::int64_t, 3> values = large.edges.at(column, row);
  const auto ramp = hn::Iota(wide, 0.0);
  const auto middle = hn::Set(wide, static_cast<double>(hn::Lanes(wide)));
  Weights weights;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto first = hn::Set(wide, static_cast<double>(values[i]));
    const auto step = hn::Set(wide, static_cast<double>(large.edges.step_x[i]));
    const auto low = hn::Add(first, hn::Mul(ramp, step));
    const auto high = hn::Add(first, hn::Mul(hn::Add(ramp, middle), step));
    weights[i] = hn::Mul(hn::Combine(d, hn::DemoteTo(half, high), hn::DemoteTo(half, low)), inverse_area);
  }
  return weights;
}

HWY_INLINE Weights weights_of(const TileTriangle& triangle, const Fragments& fragments, std::uint64_t lanes) {
  if (!triangle.triangle) {
    const std::array<float, 3>& weights = triangle.fragment->weights;
    return {shading::splat(weights[0]), shading::splat(weights[1]), shading::splat(weights[2])};
  }
  const FastTriangle& record = *triangle.triangle;
  const int column = fragments.column[0], row = fragments.row[0];
  if (!record.is_general()) return small_weights(record, column, row);
  const LargeTriangle& large = triangle.part->large[record.triangle];
  if (large.fits_double) return large_weights(large, column, row);
  HWY_ALIGN float numbers[3][most_lanes] = {};
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
    const std::array<float, 3> weights = weights_at(triangle, fragments.column[i], row);
    for (std::size_t k = 0; k < 3; ++k) numbers[k][i] = weights[k];
  }
  return {hn::Load(D(), numbers[0]), hn::Load(D(), numbers[1]), hn::Load(D(), numbers[2])};
}

/// Fragments side by side of one triangle.
class OneTriangle {
 public:
  HWY_INLINE OneTriangle(ResolveTask& task, const BatchShading& shading, const Fragments& fragments, const Share* share)
      : stride_(shading.stride), z_(fragments.z),
        weights_(weights_of(task.tile.triangles[share->id], fragments, share->lanes)) {
    const std::uint32_t begin = task.rows.row_of(share->id);
    row_ = task.rows.numbers() + begin;
  }
  HWY_INLINE V3 vector(int slot) const { return {scalar(slot), scalar(slot + 1), scalar(slot + 2)}; }
  HWY_INLINE V3 pair(int slot) const { return {scalar(slot), scalar(slot + 1), hn::Zero(D())}; }
  HWY_INLINE V3 constant(int at) const { return shading::splat3({row_[at], row_[at + 1], row_[at + 2]}); }

 private:
  HWY_INLINE V scalar(int slot) const {
    const float* a = row_ + slot;
    const V sum = hn::Add(hn::Mul(weights_[0], shading::splat(a[0])), hn::Mul(weights_[1], shading::splat(a[stride_])));
    return hn::Mul(hn::Add(sum, hn::Mul(weights_[2], shading::splat(a[2 * stride_]))), z_);
  }

  const float* row_ = nullptr;
  std::ptrdiff_t stride_;
  V z_;
  Weights weights_;
};

/// Fragments side by side of a few triangles: what a lane's triangle carries is put into the lane, then all lanes are
/// treated at once.
class FewTriangles {
 public:
  HWY_INLINE FewTriangles(ResolveTask& task, const BatchShading& shading, const Fragments& fragments,
                          const Share* shares, std::size_t count)
      : stride_(shading.stride), z_(fragments.z), count_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      mask_[i] = shares[i].mask;
      begin_[i] = task.rows.row_of(shares[i].id);
      const Weights weights = weights_of(task.tile.triangles[shares[i].id], fragments, shares[i].lanes);
      for (std::size_t k = 0; k < 3; ++k)
        weights_[k] = i == 0 ? weights[k] : hn::IfThenElse(mask_[i], weights[k], weights_[k]);
    }
    numbers_ = task.rows.numbers();
  }
  HWY_INLINE V3 vector(int slot) const { return {scalar(slot), scalar(slot + 1), scalar(slot + 2)}; }
  HWY_INLINE V3 pair(int slot) const { return {scalar(slot), scalar(slot + 1), hn::Zero(D())}; }
  HWY_INLINE V3 constant(int at) const { return {number(at), number(at + 1), number(at + 2)}; }

 private:
  HWY_INLINE V number(std::ptrdiff_t at) const {
    const float* a = numbers_ + at;
    V value = shading::splat(a[begin_[0]]);
    for (std::size_t i = 1; i < count_; ++i) value = hn::IfThenElse(mask_[i], shading::splat(a[begin_[i]]), value);
    return value;
  }
  HWY_INLINE V scalar(int slot) const {
    const V sum = hn::Add(hn::Mul(weights_[0], number(slot)), hn::Mul(weights_[1], number(slot + stride_)));
    return hn::Mul(hn::Add(sum, hn::Mul(weights_[2], number(slot + 2 * stride_))), z_);
  }

  std::ptrdiff_t stride_;
  V z_;
  std::size_t count_;
  const float* numbers_ = nullptr;
  std::array<M, most_lanes> mask_;
  std::array<std::size_t, most_lanes> begin_;
  Weights weights_;
};

/// The weights of fragments of many triangles, all lanes at once but for those of triangles in 64-bit numbers.
class GatheredWeights {
 public:
  HWY_INLINE GatheredWeights(const ResolveTask& task, const Fragments& fragments, const Share* shares,
                             std::size_t count) {
    static constexpr FastTriangle no_triangle{};
    static constexpr FastFragment no_fragment{};
    std::array<const FastTriangle*, most_lanes> triangles;
    std::array<const FastFragment*, most_lanes> tiny;
    triangles.fill(&no_triangle);
    tiny.fill(&no_fragment);
    std::uint64_t of_triangles = 0, of_tiny = 0, rest = 0;
    for (std::size_t s = 0; s < count; ++s) {
      const TileTriangle& triangle = task.tile.triangles[shares[s].id];
      const bool general = triangle.triangle && triangle.triangle->is_general();
      (general ? rest : triangle.triangle ? of_triangles : of_tiny) |= shares[s].lanes;
      if (general) continue;
      for (std::uint64_t lanes = shares[s].lanes; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        if (triangle.triangle)
          triangles[i] = triangle.triangle;
        else
          tiny[i] = triangle.fragment;
      }
    }
    const V zero = hn::Zero(D());
    weights = {zero, zero, zero};
    if (of_tiny != 0) {
      const auto four = ps::HWY_NAMESPACE::four_vectors(
          [&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), tiny[i]->weights.data()); });
      weights = {four.first, four.second, four.third};
    }
    if (of_triangles != 0) add_triangles(triangles, fragments, mask_of(of_triangles));
    if (rest != 0) add_rest(task, fragments, shares, count);
  }
  Weights weights;

 private:
  HWY_INLINE void add_triangles(const std::array<const FastTriangle*, most_lanes>& triangles,
                                const Fragments& fragments, M mask) {
    const D d;
    const DI di;
    const auto numbers = [&](std::size_t at) HWY_ATTR {
      return ps::HWY_NAMESPACE::four_vectors(
          [&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), reinterpret_cast<const float*>(triangles[i]) + at); });
    };
    const auto values = numbers(0), steps = numbers(4), box = numbers(12);
    const VI corner = hn::BitCast(di, box.first), low = hn::Set(di, 0xffff);
    const VI dx = hn::Sub(hn::Load(di, fragments.column.data()), hn::And(corner, low));
    const VI dy = hn::Sub(hn::Load(di, fragments.row.data()), hn::And(hn::ShiftRight<16>(corner), low));
    const auto value = [&](V first, V step_x, V step_y) HWY_ATTR {
      return hn::Add(hn::Add(hn::BitCast(di, first), hn::Mul(hn::BitCast(di, step_x), dx)),
                     hn::Mul(hn::BitCast(di, step_y), dy));
    };
    const VI first = value(values.first, steps.first, steps.third);
    const VI second = value(values.second, steps.second, steps.fourth);
    const VI third = hn::Sub(hn::Sub(hn::BitCast(di, values.third), first), second);
    const std::array<VI, 3> all{first, second, third};
    for (std::size_t k = 0; k < 3; ++k)
      weights[k] = hn::IfThenElse(mask, hn::Mul(hn::ConvertTo(d, all[k]), values.fourth), weights[k]);
  }
  HWY_NOINLINE void add_rest(const ResolveTask& task, const Fragments& fragments, const Share* shares,
                             std::size_t count) {
    const D d;
    HWY_ALIGN float numbers[3][most_lanes];
    for (std::size_t k = 0; k < 3; ++k) hn::Store(weights[k], d, numbers[k]);
    for (std::size_t s = 0; s < count; ++s) {
      const TileTriangle& triangle = task.tile.triangles[shares[s].id];
      if (!triangle.triangle || !triangle.triangle->is_general()) continue;
      for (std::uint64_t lanes = shares[s].lanes; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        const std::array<float, 3> single = weights_at(triangle, fragments.column[i], fragments.row[i]);
        for (std::size_t k = 0; k < 3; ++k) numbers[k][i] = single[k];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) weights[k] = hn::Load(d, numbers[k]);
  }
};
static_assert(offsetof(FastTriangle, value) == 0 && offsetof(FastTriangle, step_x) == 16 &&
              offsetof(FastTriangle, corner) == 48 && offsetof(FastFragment, weights) == 8);

/// Fragments of many triangles: four scalars of each are read at once, and several fragments interpolated together.
class ManyTriangles {
 public:
  HWY_INLINE ManyTriangles(ResolveTask& task, const BatchShading& shading, const Fragments& fragments,
                           const Share* shares, std::size_t count)
      : stride_(shading.stride), z_(fragments.z), weights_(GatheredWeights(task, fragments, shares, count).weights) {
    begin_.fill(task.rows.row_of(shares[0].id));
    for (std::size_t s = 0; s < count; ++s) {
      const std::uint32_t begin = task.rows.row_of(shares[s].id);
      for (std::uint64_t lanes = shares[s].lanes; lanes != 0; lanes &= lanes - 1)
        begin_[static_cast<std::size_t>(std::countr_zero(lanes))] = begin;
    }
    numbers_ = task.rows.numbers();
  }
  HWY_INLINE V3 vector(int slot) const {
    const auto four = ps::HWY_NAMESPACE::four_vectors_of_quarters([&](auto k) HWY_ATTR {
      const auto part = [&](std::size_t corner) HWY_ATTR {
        return hn::Mul(hn::Broadcast<k>(weights_[corner]),
                       numbers<k>(slot + static_cast<std::ptrdiff_t>(corner) * stride_));
      };
      return hn::Mul(hn::Add(hn::Add(part(0), part(1)), part(2)), hn::Broadcast<k>(z_));
    });
    return {four.first, four.second, four.third};
  }
  HWY_INLINE V3 pair(int slot) const { return vector(slot); }
  HWY_INLINE V3 constant(int at) const {
    const auto four = ps::HWY_NAMESPACE::four_vectors_of_quarters([&](auto k) HWY_ATTR { return numbers<k>(at); });
    return {four.first, four.second, four.third};
  }

 private:
  /// Four numbers of each of lanes k, k + 4, ...
  template <int k>
  HWY_INLINE V numbers(std::ptrdiff_t at) const {
    return ps::HWY_NAMESPACE::every_fourth(
        [&](std::size_t i) HWY_ATTR { return hn::LoadU(Four(), numbers_ + begin_[i] + at); }, k);
  }

  std::ptrdiff_t stride_;
  const float* numbers_ = nullptr;
  std::array<std::size_t, most_lanes> begin_;
  V z_;
  Weights weights_;
};

/// The colours of `count` shares of one surface.
HWY_NOINLINE V3 shade_shares(ResolveTask& task, std::uint32_t surface, const Fragments& fragments, const Share* shares,
                             std::size_t count, M seen) {
  const BatchShading& how = task.rows.surfaces()[surface].shading;
  if (how.source == BatchLight::none && !how.texture.texture) return shading::splat3(how.colour);
  if (fragments.in_row && count == 1)
    return shading::shade_vector(how, OneTriangle(task, how, fragments, shares), fragments.z, seen, task.texels);
  if (fragments.in_row && 4 * count <= most_lanes)
    return shading::shade_vector(how, FewTriangles(task, how, fragments, shares, count), fragments.z, seen,
                                 task.texels);
  return shading::shade_vector(how, ManyTriangles(task, how, fragments, shares, count), fragments.z, seen, task.texels);
}

/// Calls use(colours, lanes) once for every surface among the shares.
template <class Use>
HWY_INLINE void shade_by_surface(ResolveTask& task, Fragments& fragments, M seen, Use&& use) {
  const auto surface_of = [&](const Share& share) { return task.tile.triangles[share.id].surface(); };
  if (task.rows.surfaces().size() == 1) {
    use(shade_shares(task, 0, fragments, fragments.shares.data(), fragments.count, seen), seen);
    return;
  }
  std::array<Share, most_lanes> of_surface;
  std::size_t left = fragments.count;
  while (left > 0) {
    const std::uint32_t surface = surface_of(fragments.shares[0]);
    std::size_t count = 0, kept = 0;
    std::uint64_t lanes = 0;
    for (std::size_t i = 0; i < left; ++i) {
      const Share share = fragments.shares[i];
      if (surface_of(share) == surface) {
        of_surface[count++] = share;
        lanes |= share.lanes;
      } else {
        fragments.shares[kept++] = share;
      }
    }
    left = kept;
    const M mask = mask_of(lanes);
    use(shade_shares(task, surface, fragments, of_surface.data(), count, mask), mask);
  }
}

/// Which triangles the lanes in `seen` show; `ids` are those in memory at `from`.
HWY_INLINE void find_shares(VI ids, const std::uint32_t* from, std::uint64_t seen, Fragments& fragments) {
  const DI di;
  fragments.count = 0;
  for (std::uint64_t rest = seen; rest != 0;) {
    Share& share = fragments.shares[fragments.count++];
    share.id = from[std::countr_zero(rest)];
    share.mask = hn::RebindMask(D(), hn::Eq(ids, hn::Set(di, static_cast<std::int32_t>(share.id))));
    share.lanes = bits_of(share.mask) & rest;
    rest &= ~share.lanes;
  }
}

/// Writes `count` pixels; more than a vector holds means all of it.
HWY_INLINE void write(const V3& colour, Vec3f* pixels, std::size_t count) {
  const D d;
  if (count >= hn::Lanes(d)) return hn::StoreInterleaved3(colour.x, colour.y, colour.z, d, &pixels->x);
  HWY_ALIGN float buffer[3 * most_lanes];
  hn::StoreInterleaved3(colour.x, colour.y, colour.z, d, buffer);
  std::copy(buffer, buffer + 3 * count, &pixels->x);
}

}  // namespace

void resolve(ResolveTask& task) {
  const D d;
  const DI di;
  const std::size_t lanes = hn::Lanes(d);
  const V3 background = shading::splat3(task.background);
  const auto none = hn::Set(di, static_cast<std::int32_t>(TileFragments::none));
  const auto wide = static_cast<std::size_t>(task.rect.width());
  Fragments fragments;
  for (int row = task.rect.y0; row < task.rect.y1; ++row) {
    Vec3f* const pixels = task.pixels + static_cast<std::ptrdiff_t>(row) * task.width + task.rect.x0;
    fragments.row.fill(row);
    for (std::size_t x = 0; x < wide; x += lanes) {
      const std::size_t at = static_cast<std::size_t>(row - task.rect.y0) * fast_tile + x;
      const std::uint32_t* const id_at = task.tile.id.data() + at;
      const VI ids = hn::Load(di, reinterpret_cast<const std::int32_t*>(id_at));
      const M seen = hn::RebindMask(d, hn::Ne(ids, none));
      V3 colour = background;
      if (!hn::AllFalse(d, seen)) {
        fragments.inverse_z = hn::Load(d, task.tile.inverse_z.data() + at);
        fragments.z = hn::Div(hn::Set(d, 1.0f), fragments.inverse_z);
        hn::Store(hn::Iota(di, task.rect.x0 + static_cast<int>(x)), di, fragments.column.data());
        find_shares(ids, id_at, bits_of(seen), fragments);
        shade_by_surface(task, fragments, seen, [&](const V3& shaded, M mask) HWY_ATTR {
          colour = choose(mask, shaded, colour);
          const M bad =
              hn::Or(hn::Or(hn::Ne(shaded.x, shaded.x), hn::Ne(shaded.y, shaded.y)), hn::Ne(shaded.z, shaded.z));
          task.nan = task.nan || !hn::AllFalse(d, hn::And(bad, mask));
        });
      }
      write(colour, pixels + x, wide - x);
    }
  }
}

void count_texels(ResolveTask& task) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  Fragments fragments;
  fragments.in_row = false;
  HWY_ALIGN std::array<float, most_lanes> inverse_z{};
  std::size_t count = 0;
  const auto flush = [&]() HWY_ATTR {
    if (count == 0) return;
    fragments.inverse_z = hn::Load(d, inverse_z.data());
    fragments.z = hn::Div(hn::Set(d, 1.0f), fragments.inverse_z);
    fragments.count = count;
    shade_by_surface(task, fragments, hn::FirstN(d, count), [](const V3&, M) HWY_ATTR {});
    count = 0;
  };
  for (const ReplacedFragment& fragment : task.tile.replaced) {
    if (!task.rows.surfaces()[task.tile.triangles[fragment.id].surface()].textured) continue;
    fragments.shares[count] = {fragment.id, std::uint64_t{1} << count, mask_of(std::uint64_t{1} << count)};
    fragments.column[count] = task.rect.x0 + static_cast<std::int32_t>(fragment.at % fast_tile);
    fragments.row[count] = task.rect.y0 + static_cast<std::int32_t>(fragment.at / fast_tile);
    inverse_z[count] = fragment.inverse_z;
    if (++count == lanes) flush();
  }
  flush();
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

ResolveKernels resolve_kernels(Simd simd) {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  if (may_use(simd, Simd::avx512, have, HWY_AVX3)) return {N_AVX3::resolve, N_AVX3::count_texels};
  if (may_use(simd, Simd::avx2, have, HWY_AVX2)) return {N_AVX2::resolve, N_AVX2::count_texels};
  if (may_use(simd, Simd::sse4, have, HWY_SSE4)) return {N_SSE4::resolve, N_SSE4::count_texels};
#else
  static_cast<void>(simd);
#endif
  return {};
}

}  // namespace ps::raster
#endif
