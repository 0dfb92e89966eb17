#pragma once
#include "image/planes.h"

namespace ps {

/// Mean structural similarity of two planes of the same size (Wang, Bovik, Sheikh and Simoncelli, "Image quality
/// assessment: from error visibility to structural similarity", IEEE TIP 13(4), 2004): Gaussian window of 11 x 11 with
/// sigma 1.5, constants 0.01 and 0.03 times `range`, the mean over all windows that lie inside. Where a side has fewer
/// than 11 pixels, windows are at every pixel and repeat the border. 1 for equal planes.
double ssim(const ScalarImage& a, const ScalarImage& b, double range);

}  // namespace ps
