#pragma once
#include <cstdint>
#include <optional>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// How far two pictures are apart. mae, rmse and max run over all channels of all pixels, in display levels 0..255 or
/// in unit floats. A mean hides local faults: read `max` and `differing` too.
struct Comparison {
  bool identical = true;         ///< all samples are equal, as far as the caller has them
  bool identical_levels = true;  ///< all display levels are equal
  double mae = 0;
  double rmse = 0;
  std::optional<double> psnr;   ///< dB, against the largest level (255, or 1); absent when rmse is 0
  double max = 0;               ///< largest difference of one channel
  double ssim = 1;              ///< mean structural similarity, -1..1 (image/ssim.h)
  double flip = 0;              ///< mean perceived difference, 0..1 (image/flip.h)
  std::int64_t differing = 0;   ///< pixels with any difference
  std::int64_t not_finite = 0;  ///< pixels with a NaN or infinity in either picture; left out of all other numbers
                                ///< but `identical` and `differing`
};

/// Compares display levels. FLIP takes them as sRGB. Throws InputError if the sizes differ.
Comparison compare_images(const Image<Rgb8>& a, const Image<Rgb8>& b);

/// The same without SSIM and FLIP, which take nearly all of the time; floats are taken as they are.
template <class Colour>
Comparison compare_channels(const Image<Colour>& a, const Image<Colour>& b);
extern template Comparison compare_channels(const Image<Rgb8>& a, const Image<Rgb8>& b);
extern template Comparison compare_channels(const Image<Vec3f>& a, const Image<Vec3f>& b);
extern template Comparison compare_channels(const Image<Vec3d>& a, const Image<Vec3d>& b);

/// How far the opacities of two pictures are apart.
struct AlphaDifference {
  std::int64_t differing = 0;  ///< pixels
  double max = 0;              ///< largest difference, 0..1
};
/// An empty image is opaque. Both have the same size else.
AlphaDifference compare_alpha(const Image<float>& a, const Image<float>& b);

/// Compares floats as they are; SSIM and FLIP see them clamped to [0, 1], FLIP as linear light.
Comparison compare_linear(const Image<Vec3f>& a, const Image<Vec3f>& b);

}  // namespace ps
