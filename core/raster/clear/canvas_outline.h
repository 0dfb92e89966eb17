#pragma once
#include <vector>

#include "math/vec.h"
#include "options/settings.h"
#include "scene/canvas_item.h"

namespace ps::raster {

/// A filled shape of the canvas as it is filled row by row (LAB 4): its vertices as whole pixels, with what is
/// interpolated between them.
struct CanvasOutline {
  std::vector<Vec2i> pixels;   ///< array positions of the vertices, in order around it
  std::vector<Vec3d> colours;  ///< of the vertices, times their h
};

/// Vertices farther than this from the picture's centre, in pixels, are cut off first, with the colours that lie
/// between them; no picture has a longer side than that many.
inline constexpr double farthest_vertex = 1 << 16;

/// The pixels are those that lines light at the vertices (raster/clear/lines/walk_line.h). Empty where nothing of the
/// shape is as near as that. The vertices must be finite.
CanvasOutline canvas_outline(const CanvasTriangle& triangle, const Vec2i& picture_size, SamplePosition position);
CanvasOutline canvas_outline(const CanvasPolygon& polygon, const Vec2i& picture_size, SamplePosition position);

}  // namespace ps::raster
