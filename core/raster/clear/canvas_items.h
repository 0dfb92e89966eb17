#pragma once
#include <cstddef>
#include <limits>

#include "raster/assembly/canvas_line.h"
#include "raster/base/target.h"

namespace ps::raster {

/// Draws an edge of a wireframe, or a point, into the tile. There is no depth test: later lines cover earlier ones.
template <class Real, class Recorder>
void draw_edge(const RasterInputs<Real>& inputs, const ScreenLine<Real>& line, Target<Real>& target,
               Recorder& recorder);

/// Draws the part of the scene's canvas items that lies in the tile (CGFS ch. 6 to 8): lines, filled triangles with
/// colours and h interpolated between the vertices, outlines. Of the items only the first `most`.
template <class Real, class Recorder>
void draw_canvas_items(const RasterInputs<Real>& inputs, Target<Real>& target, Recorder& recorder,
                       std::size_t most = std::numeric_limits<std::size_t>::max());

/// Lines and edges of outlines among the scene's canvas items.
std::uint64_t count_canvas_lines(const Scene& scene);

}  // namespace ps::raster
