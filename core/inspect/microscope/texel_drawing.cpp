#include <fmt/format.h>

#include "inspect/microscope/drawing.h"

namespace ps {

MicroDrawing texel_drawing(const MicroTexels& texels) {
  MicroDrawing drawing;
  const int columns = texels.texels.width(), rows = texels.texels.height();
  drawing.low = Vec2d(texels.x0, texels.y0);
  drawing.high = drawing.low + Vec2d(columns, rows);
  drawing.backdrop = texels.texels;
  for (int x = 1; x < columns; ++x)
    drawing.items.push_back(
        {MicroKind::grid, MicroShape::line, {{drawing.low.x + x, drawing.low.y}, {drawing.low.x + x, drawing.high.y}}});
  for (int y = 1; y < rows; ++y)
    drawing.items.push_back(
        {MicroKind::grid, MicroShape::line, {{drawing.low.x, drawing.low.y + y}, {drawing.high.x, drawing.low.y + y}}});
  const auto shown = [&](const MicroTexels::Tap& tap) {
    return tap.x >= texels.x0 && tap.y >= texels.y0 && tap.x < texels.x0 + columns && tap.y < texels.y0 + rows;
  };
  for (const MicroTexels::Tap& tap : texels.taps) {
    const Vec2d corner(tap.x, tap.y);
    if (shown(tap))
      drawing.items.push_back({MicroKind::tap,
                               MicroShape::outline,
                               {corner, corner + Vec2d(1, 0), corner + Vec2d(1, 1), corner + Vec2d(0, 1)}});
  }
  if (!texels.footprint.empty()) drawing.items.push_back({MicroKind::footprint, MicroShape::outline, texels.footprint});
  drawing.items.push_back({MicroKind::place, MicroShape::dot, {texels.place}});
  for (const MicroTexels::Tap& tap : texels.taps)
    if (shown(tap))
      drawing.items.push_back(
          {MicroKind::tap, MicroShape::words, {Vec2d(tap.x, tap.y) + 0.5}, fmt::format("{:.0f} %", 100 * tap.weight)});
  return drawing;
}

}  // namespace ps
