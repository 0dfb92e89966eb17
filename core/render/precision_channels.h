#pragma once
#include "render/render.h"

namespace ps {

/// Renders again in double, depth buffer included, and fills `frame.precision` with what comes out otherwise. The frame
/// must have been made for the same request, with ids. Outlines and canvas items have no surfaces to compare: they give
/// shading faults alone. Throws Cancelled.
void compare_with_double(Frame& frame, const Scene& scene, const View& view, const Settings& settings,
                         const RenderRequest& request, Prepared& prepared, Progress& progress);

/// Fills `frame.depth_gap`: how many units in the last place of the stored depth value lie between the first and the
/// second surface along the pixel's ray: below 1, the depth buffer stores them as equal. Infinity where there is no
/// second surface. Surfaces that back-face culling removes do not count. Spheres are the exact ones, as rays see them.
void find_depth_gaps(Frame& frame, const Scene& scene, const View& view, const Settings& settings,
                     const RenderRequest& request, Prepared& prepared, Progress& progress);

/// On a logarithmic scale from 1 (dark) to most_depth_gap (light); below 1 red, without a second surface white.
Rgb8 depth_gap_colour(float gap);
inline constexpr double most_depth_gap = 16777216;  // all steps of a depth buffer of 24 bits

}  // namespace ps
