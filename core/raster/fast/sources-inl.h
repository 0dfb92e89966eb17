// What the triangles of visible fragments carry, interpolated: the sources that shade_batch-inl.h asks; compiled once
// for each SIMD target (Highway).
#if defined(PIXELSCOPE_FAST_SOURCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_FAST_SOURCES_INL_H_
#undef PIXELSCOPE_FAST_SOURCES_INL_H_
#else
#define PIXELSCOPE_FAST_SOURCES_INL_H_
#endif

#include <array>
#include <span>

#include "raster/fast/weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace resolving {

/// The weights of one triangle's fragments, vector after vector along a row.
class RunWeights {
 public:
  /// The first vector begins in `column` of the picture.
  HWY_INLINE RunWeights(const TileTriangle& triangle, int column, int row) : triangle_(triangle), row_(row) {
    const DI di;
    const FastTriangle& record = *triangle.triangle;
    if (!record.is_general()) {
      inverse_area_ = shading::splat(record.inverse_area);
      area_ = hn::Set(di, record.area);
      const int dx = column - record.box().x0, dy = row - record.box().y0;
      for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t first = edge_value(record.value[i], record.step_x[i], record.step_y[i], dx, dy);
        const VI step = hn::Set(di, record.step_x[i]);
        value_[i] = hn::Add(hn::Set(di, first), hn::Mul(hn::Iota(di, 0), step));
        stride_[i] = hn::Mul(step, hn::Set(di, static_cast<std::int32_t>(hn::Lanes(di))));
      }
      return;
    }
    const LargeTriangle& large = triangle.part->large[record.triangle];
    kind_ = large.fits_double ? Kind::large : Kind::exact;
    if (kind_ == Kind::exact) return;
    inverse_area_ = shading::splat(large.inverse_area);
    const hn::Repartition<double, D> wide;
    const std::array<std::int64_t, 3> values = large.edges.at(column, row);
    const auto ramp = hn::Iota(wide, 0.0), lanes = hn::Set(wide, static_cast<double>(hn::Lanes(wide)));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto step = hn::Set(wide, static_cast<double>(large.edges.step_x[i]));
      half_[i] = hn::Mul(step, lanes);
      low_[i] = hn::Add(hn::Set(wide, static_cast<double>(values[i])), hn::Mul(ramp, step));
    }
  }

  /// Of the vector that begins in `column`; to be asked for one after the other.
  HWY_INLINE Weights next(int column) {
    const D d;
    switch (kind_) {
    case Kind::small: {
      const VI third = hn::Sub(hn::Sub(area_, value_[0]), value_[1]);
      const Weights weights{hn::Mul(hn::ConvertTo(d, value_[0]), inverse_area_),
                            hn::Mul(hn::ConvertTo(d, value_[1]), inverse_area_),
                            hn::Mul(hn::ConvertTo(d, third), inverse_area_)};
      for (std::size_t i = 0; i < 2; ++i) value_[i] = hn::Add(value_[i], stride_[i]);
      return weights;
    }
    case Kind::large: {
      const hn::Half<D> half;
      Weights weights;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto high = hn::Add(low_[i], half_[i]);
        weights[i] = hn::Mul(hn::Combine(d, hn::DemoteTo(half, high), hn::DemoteTo(half, low_[i])), inverse_area_);
        low_[i] = hn::Add(high, half_[i]);
      }
      return weights;
    }
    case Kind::exact: {
      HWY_ALIGN float numbers[3][most_lanes];
      for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
        const std::array<float, 3> single = weights_at(triangle_, column + static_cast<int>(i), row_);
        for (std::size_t k = 0; k < 3; ++k) numbers[k][i] = single[k];
      }
      return {hn::Load(d, numbers[0]), hn::Load(d, numbers[1]), hn::Load(d, numbers[2])};
    }
    }
    return {};
  }

 private:
  enum class Kind { small, large, exact };
  using Wide = hn::Vec<hn::Repartition<double, D>>;

  const TileTriangle& triangle_;
  int row_;
  Kind kind_ = Kind::small;
  V inverse_area_;
  VI area_;
  std::array<VI, 2> value_, stride_;  ///< of the edges, Kind::small
  std::array<Wide, 3> low_, half_;    ///< of the first half of a vector, and from one half to the next; Kind::large
};

/// Fragments side by side of one triangle, whose numbers are `row`.
class OneTriangle {
 public:
  HWY_INLINE OneTriangle(const BatchShading& shading, const float* row, const Weights& weights, V z)
      : row_(row), stride_(shading.stride), z_(z), weights_(weights) {}
  HWY_INLINE V3 vector(int slot) const { return {scalar(slot), scalar(slot + 1), scalar(slot + 2)}; }
  HWY_INLINE V3 pair(int slot) const { return {scalar(slot), scalar(slot + 1), hn::Zero(D())}; }
  HWY_INLINE V3 constant(int at) const { return shading::splat3({row_[at], row_[at + 1], row_[at + 2]}); }

 private:
  HWY_INLINE V scalar(int slot) const {
    const float* a = row_ + slot;
    const V sum = hn::Add(hn::Mul(weights_[0], shading::splat(a[0])), hn::Mul(weights_[1], shading::splat(a[stride_])));
    return hn::Mul(hn::Add(sum, hn::Mul(weights_[2], shading::splat(a[2 * stride_]))), z_);
  }

  const float* row_;
  std::ptrdiff_t stride_;
  V z_;
  const Weights& weights_;
};

/// Fragments side by side of a few triangles: what a lane's triangle carries is put into the lane, then all lanes are
/// treated at once.
class FewTriangles {
 public:
  static constexpr std::size_t most = 4;

  HWY_INLINE FewTriangles(ResolveTask& task, const BatchShading& shading, const Fragments& fragments,
                          std::span<const Share> shares)
      : stride_(shading.stride), z_(fragments.z), count_(shares.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      mask_[i] = shares[i].mask;
      begin_[i] = task.rows.row_of(shares[i].id);
      const Weights weights = weights_of(task.tile.triangles[shares[i].id], fragments, shares[i].mask);
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
  std::array<M, most> mask_;
  std::array<std::size_t, most> begin_;
  Weights weights_;
};

/// Fragments of many triangles: four scalars of each are read at once, and several fragments interpolated together.
class ManyTriangles {
 public:
  HWY_INLINE ManyTriangles(ResolveTask& task, const BatchShading& shading, const Fragments& fragments)
      : stride_(shading.stride), z_(fragments.z), weights_(GatheredWeights(task, fragments).weights) {
    for (std::size_t i = 0; i < hn::Lanes(D()); ++i) begin_[i] = task.rows.row_of(fragments.id[i]);
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

}  // namespace resolving
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
