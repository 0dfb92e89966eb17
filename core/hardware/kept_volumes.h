#pragma once
#include <memory>
#include <vector>

#include "frame/prepared.h"
#include "hardware/picture_plan.h"

namespace ps::hardware {

/// The shadow volumes of the plan's scene, by light. They do not depend on the camera, so `prepared` keeps them: a
/// pixel is inspected with those of its picture. Throws Cancelled (base/stop.h).
std::shared_ptr<const std::vector<std::vector<raster::ShadowVolume>>> kept_volumes(const PicturePlan& plan,
                                                                                   Prepared& prepared);

}  // namespace ps::hardware
