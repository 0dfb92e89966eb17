#pragma once
#include "math/vec.h"

/// The one page on axes, facing, pixel positions and depth.
///
/// **World.** Coordinates keep their source's own numbers. No code depends on handedness: a camera is an explicit
/// frame (position, right, up, forward), never silently re-orthonormalised.
/// CGFS looks along +z with y up, CGPP along -z with y up, LAB along +z with y down: three frames, one mathematics.
///
/// **Camera space.** (x, y, z) = coordinates along right, up, forward; z is the distance in front of the camera along
/// forward. "Depth" without a further word is this z.
///
/// **Facing.** The front of triangle a, b, c is the side to which cross(b - a, c - a) points, in world space; of an
/// instance whose transform mirrors its model, the other side: a front stays a front in the mirror.
///
/// **Canvas.** Images are row-major with the origin at the top left; pixel (column, row) has its centre at
/// (column + 0.5, row + 0.5). Canvas coordinates in the book are centred with y up.
///
/// **Sample position.** A sample at offset (sx, sy) inside a pixel, both in [0, 1] from the pixel's top-left corner,
/// lies at centred canvas position x = column + sx - width/2, y = height/2 - row - sy. The centre is (0.5, 0.5). The
/// book's convention ("corner": column 300 + x, row 299 - y, no half-pixel offset) is (0, 1).
///
/// **Viewport.** A canvas position scales to the viewport: vx = x * viewport_width / width, likewise y, and the eye
/// ray is right * vx + up * vy + forward * projection_plane_d, not normalised, so that t = 1 is the viewport.
///
/// **Angles** in files are degrees; in the code, radians. A rotation by a about y has rows (c,0,-s), (0,1,0), (s,0,c),
/// as the book's demos do it.
///
/// **Colour** is linear RGB. Book scenes are display-referred: 255 in the book is 1.0 here.

namespace ps {

/// Offset of the one sample inside its pixel, from the top-left corner (see above).
inline constexpr Vec2d sample_at_centre{0.5, 0.5};
inline constexpr Vec2d sample_at_book_corner{0.0, 1.0};

/// Centred canvas position, y up, in pixels, of a sample of pixel (column, row).
template <class Real>
inline Vec2<Real> canvas_position(int column, int row, const Vec2d& offset, int width, int height) {
  return {static_cast<Real>(column) + static_cast<Real>(offset.x) - static_cast<Real>(width) / Real(2),
          static_cast<Real>(height) / Real(2) - static_cast<Real>(row) - static_cast<Real>(offset.y)};
}

/// The book's integer pixel name (x right, y up from the centre) of an array position (column, row): column 300 is
/// x = 0 on a 600-pixel canvas and row 299 is y = 0.
inline Vec2i book_pixel(int column, int row, int width, int height) {
  return {column - width / 2, height - height / 2 - 1 - row};
}

}  // namespace ps
