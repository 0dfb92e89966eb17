#pragma once
#include <string>

#include "image/image.h"

namespace ps::bench {

/// Pixels in which two pictures differ.
struct PictureDifference {
  long coverage = 0;  ///< background in one of them only
  long colour = 0;    ///< by more than `tolerance` levels in some channel, coverage not counted
  int largest = 0;    ///< levels, coverage not counted
  long covered = 0;   ///< pixels of the first picture that are not background
  std::string text() const;
};

PictureDifference compare_pictures(const Image<Rgb8>& ours, const Image<Rgb8>& theirs, Rgb8 background, int tolerance);

}  // namespace ps::bench
