#pragma once
#include "base/parallel.h"
#include "frame/frame.h"
#include "raytrace/sampling/compare.h"
#include "raytrace/sampling/plan.h"

namespace ps {

/// Which pixels adaptive sampling subdivides, from the first rays of all pixels (their colours and ids). Pixels outside
/// `region` stay as they are.
Image<std::uint8_t> pixels_to_subdivide(const Frame& frame, const TileRect& region, const SamplingPlan& plan);

/// What the frame holds of a pixel's first ray.
FirstRay first_ray(const Frame& frame, Vec2i pixel);

}  // namespace ps
