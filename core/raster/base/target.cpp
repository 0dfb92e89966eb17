#include "raster/base/target.h"

#include <algorithm>
#include <limits>
#include <span>

#include "frame/eye_directions.h"

namespace ps::raster {
namespace {

template <class T>
void fill(std::span<T> pixels, const T& value) {
  std::fill(pixels.begin(), pixels.end(), value);
}

}  // namespace

void fill_background(const Scene& scene, const TileRect& rect, Frame& frame) {
  const auto first = static_cast<std::size_t>(rect.x0);
  const auto count = static_cast<std::size_t>(rect.width());
  for (int row = rect.y0; row < rect.y1; ++row) {
    fill(frame.colour.row(row).subspan(first, count), Vec3f(scene.background));
    if (!frame.colour_double.empty()) fill(frame.colour_double.row(row).subspan(first, count), scene.background);
    if (!frame.depth.empty()) fill(frame.depth.row(row).subspan(first, count), std::numeric_limits<float>::infinity());
    if (!frame.ids.empty()) fill(frame.ids.row(row).subspan(first, count), PixelId{});
  }
}

Frame make_frame(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                 Background background) {
  const int width = view.width;
  const int height = view.height;
  Frame frame;
  frame.colour = Image<Vec3f>(width, height, Unfilled{});
  if (settings.precision == Precision::float64) frame.colour_double = Image<Vec3d>(width, height, Unfilled{});
  if (has(channels, Channel::depth)) frame.depth = Image<float>(width, height, Unfilled{});
  if (has(channels, Channel::ids)) frame.ids = Image<PixelId>(width, height, Unfilled{});
  if (background == Background::filled) fill_background(scene, {0, 0, width, height}, frame);
  if (has(channels, Channel::normal)) frame.normal = Image<Vec3f>(width, height, Vec3f(0));
  if (has(channels, Channel::barycentric)) frame.barycentric = Image<Vec3f>(width, height, Vec3f(0));
  if (has(channels, Channel::uv)) frame.uv = Image<Vec2f>(width, height, Vec2f(0));
  if (has(channels, Channel::facing)) frame.facing = Image<float>(width, height, 0.0f);
  if (has(channels, Channel::overdraw)) frame.overdraw = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::tests)) frame.tests = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::mip)) frame.mip = Image<float>(width, height, -1.0f);
  if (has(channels, Channel::shadow)) frame.shadow = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::samples)) frame.samples = Image<std::uint32_t>(width, height, 1);
  if (has(channels, Channel::direction)) frame.direction = eye_directions(view, settings);
  if (has(channels, Channel::shadow_map)) frame.shadow_map = Image<float>(width, height, -1.0f);
  if (has(channels, Channel::stencil)) frame.stencil = Image<std::int32_t>(width, height, 0);
  if (has(channels, Channel::environment)) frame.environment = Image<Vec3f>(width, height, Vec3f(-1));
  return frame;
}

}  // namespace ps::raster
