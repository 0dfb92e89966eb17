#pragma once
#include "image/image.h"
#include "math/vec.h"

namespace ps {

enum class DifferenceMode {
  absolute,  ///< |B - A| per channel, black where equal
  sign       ///< (B - A) / 2 about middle grey: lighter where B is brighter
};

struct DifferenceOptions {
  double gain = 1;  ///< differences are multiplied by this before they are clamped
  DifferenceMode mode = DifferenceMode::absolute;
};

/// A picture of what parts two pictures of display levels. Both must have the same size (InputError).
Image<Rgb8> difference_picture(const Image<Rgb8>& a, const Image<Rgb8>& b, const DifferenceOptions& options = {});
/// One pixel of it.
Rgb8 difference_pixel(Rgb8 a, Rgb8 b, const DifferenceOptions& options);

}  // namespace ps
