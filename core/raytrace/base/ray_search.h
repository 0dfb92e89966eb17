#pragma once
#include <span>

#include "raytrace/base/ray.h"

namespace ps {

/// Which primitive does a ray meet? All that the tracer asks. The clear path answers (clear/intersector.h), or a fast
/// search that finds the same hits to the last bit (fast/fast_intersector.h); a picture is drawn with one of them.
template <class Real>
class RaySearch {
 public:
  virtual ~RaySearch() = default;
  /// The nearest primitive that the ray meets; of several at the same t the one with the lowest number.
  virtual Hit<Real> nearest(const Ray<Real>& ray) const = 0;
  /// Any primitive that the ray meets.
  virtual Hit<Real> any(const Ray<Real>& ray) const = 0;
  /// nearest() of each ray, into the hit with the same index; may be faster for rays of neighbouring pixels.
  virtual void nearest_of_each(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const = 0;

 protected:
  RaySearch() = default;
  RaySearch(const RaySearch&) = default;
  RaySearch& operator=(const RaySearch&) = default;
};

}  // namespace ps
