#pragma once
#include <optional>

#include "base/parallel.h"
#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// The measure that a map of the difference between two pictures shows at each pixel.
enum class DifferenceMode {
  absolute,  ///< |B - A| of each channel, in levels: black where equal
  sign,      ///< B - A of the channel in which they differ most, in levels: blue where A is brighter, orange where B is
  relative,  ///< the largest |B - A| / (A + 1 % of white) of a channel: what is lost in the dark shows
  flip       ///< the difference as seen when the pictures are flipped in place (image/flip.h), 0 to 1
};

struct DifferenceOptions {
  double gain = 1;  ///< values are multiplied by this before they are clamped
  DifferenceMode mode = DifferenceMode::absolute;
};

/// The largest difference of a channel between two pixels: levels of 255.
int largest_difference(Rgb8 a, Rgb8 b);

/// The value that is white without a gain: 255 levels, a relative difference of 1, a FLIP of 1.
double full_scale(DifferenceMode mode);

/// The number that the map shows of each pixel; above 0 but for `sign`. Both pictures must have the same size
/// (InputError). FLIP takes far longer than a frame.
Image<float> difference_values(const Image<Rgb8>& a, const Image<Rgb8>& b, DifferenceMode mode);

/// A remark about such numbers.
struct DifferenceNumbers {
  double mean = 0;        ///< of their sizes, as all that follows
  double percentile = 0;  ///< 99.9 % of the pixels have at most this
  double largest = 0;
  Vec2i at{-1, -1};      ///< the pixel with the largest, the first in reading order; (-1, -1) if none differs
  double differing = 0;  ///< share of the pixels with another value than 0
};
/// The figures over the pixels of the region, or over all.
DifferenceNumbers difference_numbers(const Image<float>& values, const std::optional<TileRect>& region = {});

/// The gain with which the 99.9th percentile is white, or the largest value where fewer pixels differ; from 1 to 256.
double gain_that_shows(const DifferenceNumbers& numbers, DifferenceMode mode);

/// The map as a picture. `sign`, `relative` and `flip` have false colours (difference_colour), `absolute` has the
/// colour of the difference. The sizes must be equal (InputError).
Image<Rgb8> difference_picture(const Image<Rgb8>& a, const Image<Rgb8>& b, const DifferenceOptions& options = {});
/// The same from values that are known; not for `absolute`, which shows each channel.
Image<Rgb8> difference_picture(const Image<float>& values, const DifferenceOptions& options);
/// One pixel of the map of `absolute`.
Rgb8 difference_pixel(Rgb8 a, Rgb8 b, double gain);
/// The colour for a value: grey for `absolute`; for `sign` from black over the colour of A or B to white; else a heat
/// map.
Rgb8 difference_colour(double value, const DifferenceOptions& options);

}  // namespace ps
