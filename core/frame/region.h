#pragma once
#include <algorithm>

#include "frame/frame.h"

namespace ps {

/// The pixels that both rectangles hold; may have no width or height.
inline TileRect common_part(const TileRect& a, const TileRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}
inline bool is_empty(const TileRect& rect) { return rect.x0 >= rect.x1 || rect.y0 >= rect.y1; }
/// One pixel larger on each side.
inline TileRect grown(const TileRect& rect) { return {rect.x0 - 1, rect.y0 - 1, rect.x1 + 1, rect.y1 + 1}; }

/// The rectangle that a request asks for, inside a picture of this size.
inline TileRect asked_region(const RenderRequest& request, int width, int height) {
  const TileRect all{0, 0, width, height};
  return request.region ? common_part(*request.region, all) : all;
}

/// Whether the pixels outside that rectangle are to be cleared.
inline bool clears_outside(const RenderRequest& request) { return request.region && request.outside == Outside::black; }

/// Makes every pixel outside the rectangle black, and its channels as for the background.
void clear_outside(const TileRect& region, Frame& frame);

}  // namespace ps
