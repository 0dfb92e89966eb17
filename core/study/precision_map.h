#pragma once
#include <array>
#include <optional>

#include "render/render.h"

namespace ps {

/// What a pixel gets wrong because of its arithmetic, against the same pixel in double.
enum class PrecisionFault {
  none,
  false_hit,     ///< shows something where double shows nothing
  missed_hit,    ///< shows nothing where double shows something
  wrong_winner,  ///< another object or triangle
  shading        ///< the same surface in another colour, by more than one level
};
inline constexpr std::size_t precision_fault_count = 5;
/// For people: "wrong winner".
std::string_view precision_fault_label(PrecisionFault fault);
Rgb8 precision_fault_colour(PrecisionFault fault);

struct PrecisionMap {
  Image<PrecisionFault> faults;
  std::array<std::uint64_t, precision_fault_count> counts{};  ///< of pixels, by fault
  /// How many units in the last place of the stored depth value lie between the first and the second surface along the
  /// pixel's ray: 0 = the depth buffer cannot tell them apart. Infinity where there is no second surface. Surfaces that
  /// back-face culling removes do not count. Spheres are the exact ones, as rays see them.
  Image<float> gap;
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
