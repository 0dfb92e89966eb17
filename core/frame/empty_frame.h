#pragma once
#include <type_traits>

#include "frame/frame.h"
#include "frame/view.h"

namespace ps {

/// A frame with the channels that were asked for.
template <class Real>
Frame empty_frame(const View& view, const RenderRequest& request) {
  const auto give_size = [&](auto& image, Channel channel) {
    using Picture = std::remove_reference_t<decltype(image)>;
    if (has(request.channels, channel)) image = Picture(view.width, view.height);
  };
  Frame frame;
  frame.colour = Image<Vec3f>(view.width, view.height);
  if constexpr (std::is_same_v<Real, double>) frame.colour_double = Image<Vec3d>(view.width, view.height);
  give_size(frame.depth, Channel::depth);
  give_size(frame.normal, Channel::normal);
  give_size(frame.barycentric, Channel::barycentric);
  give_size(frame.uv, Channel::uv);
  give_size(frame.ids, Channel::ids);
  give_size(frame.facing, Channel::facing);
  give_size(frame.overdraw, Channel::overdraw);
  give_size(frame.tests, Channel::tests);
  give_size(frame.mip, Channel::mip);
  give_size(frame.shadow, Channel::shadow);
  give_size(frame.samples, Channel::samples);
  give_size(frame.direction, Channel::direction);
  give_size(frame.shadow_map, Channel::shadow_map);
  for (float& depth : frame.shadow_map.pixels()) depth = -1;  // rays have no maps
  give_size(frame.stencil, Channel::stencil);
  give_size(frame.environment, Channel::environment);
  for (Vec3f& colour : frame.environment.pixels()) colour = Vec3f(-1);
  return frame;
}

}  // namespace ps
