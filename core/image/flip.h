#pragma once
#include "image/image.h"
#include "image/planes.h"
#include "math/vec.h"

namespace ps {

/// How a picture is looked at.
struct FlipOptions {
  /// Pixels for each degree of the visual field. The default is the paper's: a 0.7 m wide screen of 3840 pixels, seen
  /// from 0.7 m.
  double pixels_per_degree = 67.020643276582255;
};

/// The perceived difference of each pixel, in [0, 1], when a person flips between two pictures of linear RGB in [0, 1]
/// (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating
/// Images", HPG 2020; the version for low dynamic range).
ScalarImage flip_map(const Image<Vec3d>& reference, const Image<Vec3d>& test, const FlipOptions& options = {});

/// The mean of the map.
double flip(const Image<Vec3d>& reference, const Image<Vec3d>& test, const FlipOptions& options = {});

/// The same for display levels, which are taken as sRGB.
ScalarImage flip_map(const Image<Rgb8>& reference, const Image<Rgb8>& test, const FlipOptions& options = {});
double flip(const Image<Rgb8>& reference, const Image<Rgb8>& test, const FlipOptions& options = {});

}  // namespace ps
