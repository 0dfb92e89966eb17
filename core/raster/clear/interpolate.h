#pragma once
#include <cstdint>

namespace ps::raster {

/// The book's Interpolate (CGFS ch. 6) without its list: value number k belongs to i0 + k and is made by adding the
/// slope k times, so its rounding errors add up as they do in the book. Numbers are asked for in rising order.
template <class Real>
class InterpolatedValues {
 public:
  /// Values d0 at i0 to d1 at i1; a single value where i0 = i1.
  InterpolatedValues(Real i0, Real d0, Real i1, Real d1)
      : slope_(i0 == i1 ? Real(0) : (d1 - d0) / (i1 - i0)), value_(d0) {}

  /// Value number `index`; the index may stay or grow from call to call, never fall.
  Real at(std::int64_t index) {
    for (; index_ < index; ++index_) value_ += slope_;
    return value_;
  }

 private:
  Real slope_;
  Real value_;
  std::int64_t index_ = 0;
};

}  // namespace ps::raster
