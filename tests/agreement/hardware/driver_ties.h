#pragma once
#include "options/settings.h"

namespace ps::test {

/// Samples of triangles that two renderers may give away differently.
struct TieCount {
  long covered = 0, differ = 0;
  long ties = 0;        ///< samples exactly on an edge that one of the two covers
  double farthest = 0;  ///< of those that differ from an edge: pixels
};

enum class Reach { within_picture, beyond_it };

/// Draws triangles by hardware and rasterizer, each alone. Their vertices lie on corners or centres of pixels, 32
/// pixels apart, so that edges pass through many samples.
TieCount count_ties(Reach reach, Renderer hardware);

}  // namespace ps::test
