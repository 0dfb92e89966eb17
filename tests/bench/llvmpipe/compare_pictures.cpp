#include "bench/llvmpipe/compare_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "base/check.h"

namespace ps::bench {

std::string PictureDifference::text() const {
  return fmt::format("{} px covered; {} differ in coverage, {} in colour, by {} levels at most", covered, coverage,
                     colour, largest);
}

PictureDifference compare_pictures(const Image<Rgb8>& ours, const Image<Rgb8>& theirs, Rgb8 background, int tolerance) {
  PS_ASSERT(ours.width() == theirs.width() && ours.height() == theirs.height(), "pictures of one size");
  PictureDifference difference;
  for (std::size_t i = 0; i < ours.pixels().size(); ++i) {
    const Rgb8 a = ours.pixels()[i], b = theirs.pixels()[i];
    difference.covered += a != background;
    if ((a == background) != (b == background)) {
      ++difference.coverage;
      continue;
    }
    const int levels = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
    difference.largest = std::max(difference.largest, levels);
    difference.colour += levels > tolerance;
  }
  return difference;
}

}  // namespace ps::bench
