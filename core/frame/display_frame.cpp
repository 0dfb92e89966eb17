#include "frame/display_frame.h"

namespace ps {

DisplayTransform display_transform(const Settings& settings) {
  return {settings.exposure, settings.gamma, settings.colour_depth};
}

void display_tile(const Frame& frame, const Settings& settings, const TileRect& tile, Image<Rgb8>& target) {
  PS_ASSERT(target.width() == frame.width() && target.height() == frame.height(), "target of the frame's size");
  PS_ASSERT(tile.x0 >= 0 && tile.y0 >= 0 && tile.x1 <= frame.width() && tile.y1 <= frame.height(),
            "tile inside the frame");
  const DisplayTransform transform = display_transform(settings);
  const auto first = static_cast<std::size_t>(tile.x0);
  const auto count = static_cast<std::size_t>(tile.width());
  for (int y = tile.y0; y < tile.y1; ++y) {
    const auto levels = target.row(y).subspan(first, count);
    if (frame.colour_double.empty())
      display_row(frame.colour.row(y).subspan(first, count), levels, transform);
    else
      display_row(frame.colour_double.row(y).subspan(first, count), levels, transform);
  }
}

Image<Rgb8> display_frame(const Frame& frame, const Settings& settings) {
  Image<Rgb8> levels(frame.width(), frame.height());
  display_tile(frame, settings, {0, 0, frame.width(), frame.height()}, levels);
  return levels;
}

void finish_tile(const RenderRequest& request, const Settings& settings, const Frame& frame, const TileRect& tile) {
  if (request.levels) display_tile(frame, settings, tile, *request.levels);
  if (request.on_tile) request.on_tile(frame, tile);
}

Vec3d linear_at(const Frame& frame, Vec2i pixel) {
  return frame.colour_double.empty() ? Vec3d(frame.colour.at(pixel.x, pixel.y))
                                     : frame.colour_double.at(pixel.x, pixel.y);
}

Rgb8 display_at(const Frame& frame, const Settings& settings, Vec2i pixel) {
  return display_pixel(linear_at(frame, pixel), display_transform(settings));
}

}  // namespace ps
