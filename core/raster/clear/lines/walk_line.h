#pragma once
#include <cmath>

#include "math/vec.h"
#include "options/settings.h"
#include "raster/clear/lines/bresenham.h"
#include "raster/clear/lines/general.h"
#include "raster/clear/lines/interpolated.h"
#include "raster/clear/lines/single_axis.h"

namespace ps::raster {

/// The book's name (math/conventions.h, book_pixel) of the pixel that a canvas point lights. With the sample at the
/// centre that is the pixel that contains the point; with the book's convention both coordinates lose their fraction,
/// as in the book's own programs.
template <class Real>
inline Vec2i book_pixel_at(const Vec2<Real>& point, SamplePosition position) {
  switch (position) {
  case SamplePosition::centre:
    return {static_cast<int>(std::floor(point.x)), static_cast<int>(std::floor(point.y))};
  case SamplePosition::corner:
    return {static_cast<int>(point.x), static_cast<int>(point.y)};
  }
  return {};
}

/// Calls visit(pixel, step) with the book's name of each pixel of the line, in the order in which it is drawn. Canvas
/// coordinates: centred, y up, whole numbers at pixel borders; they must be finite and below 2^30.
template <class Real, class Visit>
void walk_line(LineAlgorithm algorithm, const Vec2<Real>& from, const Vec2<Real>& to, SamplePosition position,
               Visit&& visit) {
  const auto point = [&](const Vec2<Real>& p, int step) { visit(book_pixel_at(p, position), step); };
  switch (algorithm) {
  case LineAlgorithm::general:
    return walk_general(from, to, point);
  case LineAlgorithm::y_of_x:
    return walk_y_of_x(from, to, point);
  case LineAlgorithm::x_of_y:
    return walk_x_of_y(from, to, point);
  case LineAlgorithm::interpolate:
    return walk_interpolated(from, to, point);
  case LineAlgorithm::bresenham:
    return walk_bresenham(book_pixel_at(from, position), book_pixel_at(to, position), visit);
  }
}

}  // namespace ps::raster
