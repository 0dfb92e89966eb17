#pragma once
#include "raster/base/screen_triangle.h"

namespace ps::raster {

/// Prepares the line a..b, in centred canvas coordinates, for walking: cut to the guard band and with its box. False if
/// nothing of it can be drawn.
template <class Real>
bool make_canvas_line(Vec2<Real> a, Vec2<Real> b, int columns, int rows, ScreenLine<Real>& line);

/// Centred canvas coordinates have their origin at the centre of a pixel where a side is odd; the book's pixel names
/// count from the pixel's lower left corner. This is added to a canvas position before it is walked.
inline double odd_shift(int size) { return size % 2 == 0 ? 0.0 : 0.5; }

/// Array position of a pixel with this name: the inverse of book_pixel.
inline Vec2i array_pixel(const Vec2i& book, int columns, int rows) {
  return {book.x + columns / 2, rows - rows / 2 - 1 - book.y};
}

}  // namespace ps::raster
