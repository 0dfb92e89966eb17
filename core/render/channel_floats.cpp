#include "render/channel_floats.h"

#include <cmath>
#include <limits>

#include "frame/display_frame.h"
#include "render/channel_value.h"

namespace ps {
namespace {

/// value(x, y) for each pixel.
template <class Value>
Image<float> number_image(const Frame& frame, Value value) {
  Image<float> image(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) image.row(y)[static_cast<std::size_t>(x)] = static_cast<float>(value(x, y));
  return image;
}

Image<Vec3f> uv_image(const Frame& frame) {
  Image<Vec3f> image(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) image.at(x, y) = {frame.uv.at(x, y).x, frame.uv.at(x, y).y, 0};
  return image;
}

/// 0 finite, 1 NaN, 2 infinite.
int kind_of_colour(const Vec3d& c) {
  if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) return 1;
  return std::isinf(c.r) || std::isinf(c.g) || std::isinf(c.b) ? 2 : 0;
}

}  // namespace

ChannelFloats channel_floats(const Frame& frame, ShownChannel channel) {
  switch (channel) {
  case ShownChannel::colour:
    return frame.colour;
  case ShownChannel::depth:
    return frame.depth;
  case ShownChannel::depth_gap:
    return frame.depth_gap;
  case ShownChannel::facing:
    return frame.facing;
  case ShownChannel::normal:
    return frame.normal;
  case ShownChannel::direction:
    return frame.direction;
  case ShownChannel::barycentric:
    return frame.barycentric;
  case ShownChannel::environment:
    return frame.environment;
  case ShownChannel::uv:
    return uv_image(frame);
  case ShownChannel::overdraw:
  case ShownChannel::tests:
  case ShownChannel::mip:
  case ShownChannel::samples:
  case ShownChannel::shadow:
  case ShownChannel::shadow_map:
  case ShownChannel::stencil:
    return number_image(frame, [&](int x, int y) {
      return heat_value(frame, channel, x, y).value_or(std::numeric_limits<double>::quiet_NaN());
    });
  case ShownChannel::triangle:
    return number_image(frame, [&](int x, int y) { return frame.ids.at(x, y).triangle; });
  case ShownChannel::object:
    return number_image(frame, [&](int x, int y) { return frame.ids.at(x, y).object; });
  case ShownChannel::hit:
    return number_image(frame, [&](int x, int y) { return frame.ids.at(x, y).object < 0 ? 0 : 1; });
  case ShownChannel::nan:
    return number_image(frame, [&](int x, int y) { return kind_of_colour(linear_at(frame, {x, y})); });
  case ShownChannel::precision:
    return number_image(frame, [&](int x, int y) { return static_cast<int>(frame.precision.at(x, y)); });
  }
  return {};
}

}  // namespace ps
