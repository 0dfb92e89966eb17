#pragma once
#include "study/stability/support.h"

namespace ps::stability {

// Where the points that the book's camera finds on its ground sphere really lie, and what an epsilon does about them.
// The sphere touches y = -1 below the camera; pictures have 600 x 600 rays through the corners of their pixels, as the
// book has them.

/// The roots of a ray with the sphere: by the textbook's formula, or with the discriminant from the remainder vector.
enum class SphereForm { textbook, remainder };

/// The numbers in which the distance of a point from the surface is computed: more precise ones, or those of the hit
/// itself, whose own rounding is as large as the error that they measure.
enum class ErrorIn { long_double, same };

/// Distance of the points from the sphere's surface.
struct OffSurface {
  double rms = 0, largest = 0;
};
OffSurface hit_off_surface(double radius, SphereForm form, Precision numbers, ErrorIn error_in,
                           const StabilityRun& run);

/// Percentage of the points on the ground of radius 5000, lit by the book's point light at (2, 1, 0), whose shadow ray
/// meets the ground again beyond `epsilon`: in float, hit and shadow both by the remainder form, from the point as
/// found.
double false_shadow_by_remainder(float epsilon, const StabilityRun& run);

}  // namespace ps::stability
