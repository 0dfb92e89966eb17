// Weights of visible fragments on the screen, found again from their triangles; compiled once for each SIMD target
// (Highway).
#if defined(PIXELSCOPE_FAST_WEIGHTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_FAST_WEIGHTS_INL_H_
#undef PIXELSCOPE_FAST_WEIGHTS_INL_H_
#else
#define PIXELSCOPE_FAST_WEIGHTS_INL_H_
#endif

#include <bit>
#include <cstddef>

#include "math/mask_bits-inl.h"
#include "raster/fast/resolve.h"
#include "raster/fast/shade_batch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace resolving {

namespace hn = hwy::HWY_NAMESPACE;
using shading::D;
using shading::M;
using shading::V;
using shading::V3;
using DI = hn::Rebind<std::int32_t, D>;
using VI = hn::Vec<DI>;
using Four = hn::FixedTag<float, 4>;

constexpr std::size_t most_lanes = hn::MaxLanes(D());

/// The lanes of a vector that show one triangle.
struct Share {
  std::uint32_t id = 0;
  M mask{};
};

/// The fragments of a vector and where they lie.
struct Fragments {
  alignas(64) std::array<std::uint32_t, most_lanes> id{};  ///< of the tile's triangles; some shown one in empty lanes
  V z, inverse_z;
  alignas(64) std::array<std::int32_t, most_lanes> column{}, row{};  ///< in the picture
  bool in_row = true;                                                ///< columns follow each other
};

/// An edge's values where they fit 32 bits; products may wrap around in unused lanes.
HWY_INLINE std::int32_t edge_value(std::int32_t value, std::int32_t step_x, std::int32_t step_y, int dx, int dy) {
  const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
  return static_cast<std::int32_t>(u(value) + u(step_x) * u(dx) + u(step_y) * u(dy));
}

/// The weights of one fragment of a triangle.
HWY_INLINE std::array<float, 3> weights_at(const TileTriangle& triangle, int column, int row) {
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

HWY_INLINE Weights weights_of(const TileTriangle& triangle, const Fragments& fragments, M mask) {
  const FastTriangle& record = *triangle.triangle;
  const int column = fragments.column[0], row = fragments.row[0];
  if (!record.is_general()) return small_weights(record, column, row);
  const LargeTriangle& large = triangle.part->large[record.triangle];
  if (large.fits_double) return large_weights(large, column, row);
  HWY_ALIGN float numbers[3][most_lanes] = {};
  for (std::uint64_t lanes = ps::HWY_NAMESPACE::bits_of(D(), mask); lanes != 0; lanes &= lanes - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
    const std::array<float, 3> weights = weights_at(triangle, fragments.column[i], row);
    for (std::size_t k = 0; k < 3; ++k) numbers[k][i] = weights[k];
  }
  return {hn::Load(D(), numbers[0]), hn::Load(D(), numbers[1]), hn::Load(D(), numbers[2])};
}

/// The weights of fragments of many triangles, all lanes at once but for those of triangles in 64-bit numbers.
class GatheredWeights {
 public:
  HWY_INLINE GatheredWeights(const ResolveTask& task, const Fragments& fragments) {
    std::array<const FastTriangle*, most_lanes> triangles;
    std::uint64_t general = 0;
    for (std::size_t i = 0; i < hn::Lanes(D()); ++i) {
      triangles[i] = task.tile.triangles[fragments.id[i]].triangle;
      general |= std::uint64_t{triangles[i]->is_general()} << i;
    }
    add_triangles(triangles, fragments);
    if (general != 0) add_general(task, fragments, general);
  }
  Weights weights;

 private:
  HWY_INLINE void add_triangles(const std::array<const FastTriangle*, most_lanes>& triangles,
                                const Fragments& fragments) {
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
    for (std::size_t k = 0; k < 3; ++k) weights[k] = hn::Mul(hn::ConvertTo(d, all[k]), values.fourth);
  }
  HWY_NOINLINE void add_general(const ResolveTask& task, const Fragments& fragments, std::uint64_t lanes) {
    const D d;
    HWY_ALIGN float numbers[3][most_lanes];
    for (std::size_t k = 0; k < 3; ++k) hn::Store(weights[k], d, numbers[k]);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
      const std::array<float, 3> single =
          weights_at(task.tile.triangles[fragments.id[i]], fragments.column[i], fragments.row[i]);
      for (std::size_t k = 0; k < 3; ++k) numbers[k][i] = single[k];
    }
    for (std::size_t k = 0; k < 3; ++k) weights[k] = hn::Load(d, numbers[k]);
  }
};
static_assert(offsetof(FastTriangle, value) == 0 && offsetof(FastTriangle, step_x) == 16 &&
              offsetof(FastTriangle, corner) == 48);

}  // namespace resolving
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
