#pragma once
#include "image/colour_depth.h"
#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// How linear colour becomes display levels: multiply by the exposure, clamp to [0, 1], raise to 1/gamma, quantise
/// rounding half to even (CGFS ch. 1 and its demos; CGPP 15.3.2). NaN becomes 0.
struct DisplayTransform {
  double exposure = 1;
  double gamma = 1;
  ColourDepth depth = ColourDepth::bits24;
  bool operator==(const DisplayTransform&) const = default;
};

/// The display levels of one colour. With 16 or 15 bits the colour is quantised to 5-6-5 or 5-5-5 bits and expanded
/// back to 8, so that the bands show. Every picture and the inspector get their levels from here.
Rgb8 display_pixel(const Vec3d& linear, const DisplayTransform& transform);

/// display_pixel for every pixel, to the same bits.
Image<Rgb8> display_image(const Image<Vec3f>& linear, const DisplayTransform& transform = {});
Image<Rgb8> display_image(const Image<Vec3d>& linear, const DisplayTransform& transform = {});

/// The same for a run of pixels; both spans have the same length.
void display_row(std::span<const Vec3f> linear, std::span<Rgb8> levels, const DisplayTransform& transform);
void display_row(std::span<const Vec3d> linear, std::span<Rgb8> levels, const DisplayTransform& transform);

/// Number of pixels with a NaN in any channel.
std::uint64_t count_nan_pixels(const Image<Vec3f>& linear);
std::uint64_t count_nan_pixels(const Image<Vec3d>& linear);

/// Display levels as numbers again: level / 255.
Image<Vec3f> to_unit(const Image<Rgb8>& levels);

}  // namespace ps
