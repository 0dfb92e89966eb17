#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardware/picture_plan.h"

namespace ps::hardware {

/// Finds the triangles that may reach a pixel: by their vertices in double precision, with a margin that is wide beside
/// what a driver rounds. It is a bound and decides nothing: which of them cover the pixel, the driver reports.
class NearTest {
 public:
  NearTest(const PicturePlan& plan, Vec2i pixel);

  /// Of the object's triangles: may it reach the pixel?
  std::vector<bool> of_object(std::size_t object) const;

 private:
  const PicturePlan& plan_;
  double left_, right_, top_, bottom_;  ///< pixels
};

}  // namespace ps::hardware
