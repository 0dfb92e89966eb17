#pragma once
#include <array>
#include <optional>

#include "render/render.h"

namespace ps {

struct PrecisionMap {
  Image<PrecisionFault> faults;
  std::array<std::uint64_t, precision_fault_count> counts{};  ///< of pixels, by fault
  Image<float> gap;                                           ///< see find_depth_gaps() in render/precision_channels.h
  std::uint64_t count(PrecisionFault fault) const { return counts[static_cast<std::size_t>(fault)]; }
};

/// Renders with the settings as they are and with the same in double, depth buffer included. Outlines and canvas items
/// have no surfaces to compare: they give shading faults alone. Throws Cancelled.
PrecisionMap precision_map(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                           Progress& progress, WorkerPriority priority = WorkerPriority::normal);

/// The faults as colours; pixels without one are dark grey.
Image<Rgb8> fault_picture(const PrecisionMap& map);
/// The gap on a logarithmic scale from 1 (dark) to 2^24 (light); below 1 red, without a second surface white.
Image<Rgb8> gap_picture(const PrecisionMap& map);

}  // namespace ps
