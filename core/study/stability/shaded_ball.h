#pragma once
#include <vector>

#include "image/image.h"
#include "scene/mesh.h"
#include "study/stability/support.h"

namespace ps::stability {

/// How a ball of triangles is cut along meridians and parallels.
struct BallCut {
  int slices, stacks;
  double triangles() const { return 2.0 * slices * (stacks - 1); }
};

/// Balls of radius 1 that fill a picture 200 px wide, seen from 100 radii away, under directional lights. The program
/// draws them: triangles with the rasterizer and the smooth ball with the ray tracer. Lights shine from anywhere in
/// front, so that the highlight lies on the visible side.

/// What a ball of triangles keeps of the peak of a highlight, which is 1 on the smooth ball.
struct KeptPeaks {
  double mean = 0;
  double least = 0;  ///< of 20 lights; with more lights the mean of the least of each 20
};

/// The brightest pixel of a black ball with a white highlight, over `lights` lights, a multiple of 20. Of `settings`
/// those of shading count.
KeptPeaks kept_peaks(const Mesh& triangles, double exponent, const Settings& settings, int lights,
                     const StabilityRun& run);

/// Differences from the smooth ball, of white balls under one light of intensity 0.5 at a time, 20 in all: its diffuse
/// light and its highlight together reach white and no more.
class BallErrors {
 public:
  BallErrors(double exponent, const StabilityRun& run);
  /// RMSE in levels of 255, over the pixels that show both balls. Of `settings` those of shading count.
  double rmse(const Mesh& triangles, const Settings& settings) const;

 private:
  Material material_;
  int side_;
  const StabilityRun& run_;
  std::vector<Vec3d> lights_;
  std::vector<Image<Vec3f>> truths_;  ///< the smooth ball under three lights each
  Image<std::uint8_t> shown_;         ///< 1 where a pixel shows it
};

/// How far normals as they are interpolated, and normals brought back to length 1, take a white ball of triangles from
/// the same triangles shaded in double with normals of length 1: largest difference in levels of 255, over the ball's
/// pixels and 6 lights of intensity 0.5, one at a time.
struct NormalErrors {
  double as_interpolated = 0, renormalised = 0;
};
NormalErrors normal_errors(const Mesh& triangles, double exponent, const StabilityRun& run);

}  // namespace ps::stability
