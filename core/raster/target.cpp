#include "raster/target.h"

#include <limits>

#include "render/eye_directions.h"

namespace ps::raster {

Frame make_frame(const Scene& scene, const View& view, const Settings& settings, Channel channels) {
  const int width = view.width;
  const int height = view.height;
  Frame frame;
  frame.colour = Image<Vec3f>(width, height, Vec3f(scene.background));
  if (settings.precision == Precision::float64) frame.colour_double = Image<Vec3d>(width, height, scene.background);
  if (has(channels, Channel::depth)) frame.depth = Image<float>(width, height, std::numeric_limits<float>::infinity());
  if (has(channels, Channel::normal)) frame.normal = Image<Vec3f>(width, height, Vec3f(0));
  if (has(channels, Channel::barycentric)) frame.barycentric = Image<Vec3f>(width, height, Vec3f(0));
  if (has(channels, Channel::uv)) frame.uv = Image<Vec2f>(width, height, Vec2f(0));
  if (has(channels, Channel::ids)) frame.ids = Image<PixelId>(width, height);
  if (has(channels, Channel::facing)) frame.facing = Image<float>(width, height, 0.0f);
  if (has(channels, Channel::overdraw)) frame.overdraw = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::tests)) frame.tests = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::mip)) frame.mip = Image<float>(width, height, -1.0f);
  if (has(channels, Channel::shadow)) frame.shadow = Image<std::uint32_t>(width, height, 0);
  if (has(channels, Channel::samples)) frame.samples = Image<std::uint32_t>(width, height, 1);
  if (has(channels, Channel::direction)) frame.direction = eye_directions(view, settings);
  return frame;
}

}  // namespace ps::raster
