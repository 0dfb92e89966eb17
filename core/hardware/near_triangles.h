#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardware/picture_plan.h"
#include "raster/shadow/shadow_volume.h"

namespace ps::hardware {

/// Finds the triangles that may reach some pixels: by their vertices in double precision, with a margin that is wide
/// beside what a driver rounds. It is a bound and decides nothing: which of them cover a pixel, the driver reports.
class NearTest {
 public:
  NearTest(const PicturePlan& plan, const TileRect& pixels);

  /// Of the object's triangles: may it reach them?
  std::vector<bool> of_object(std::size_t object) const;
  /// The same for a shadow volume's surface.
  std::vector<bool> of_volume(const raster::ShadowVolume& volume) const;

 private:
  std::uint8_t beyond(const Vec3d& world) const;

  const PicturePlan& plan_;
  double left_, right_, top_, bottom_;  ///< pixels
};

}  // namespace ps::hardware
