#pragma once
#include <type_traits>

#include "frame/frame.h"
#include "frame/region.h"
#include "frame/view.h"

namespace ps {

/// A frame with the channels that were asked for. Where no code reads pixels outside of a region, colours and the
/// commonest channels hold anything: the renderer writes every pixel of the region.
template <class Real>
Frame empty_frame(const View& view, const RenderRequest& request) {
  const bool fills = !request.region || clears_outside(request);
  const auto give_all = [&](auto& image) {
    using Picture = std::remove_reference_t<decltype(image)>;
    image = fills ? Picture(view.width, view.height) : Picture(view.width, view.height, Unfilled{});
  };
  const auto give_size = [&](auto& image, Channel channel) {
    using Picture = std::remove_reference_t<decltype(image)>;
    if (has(request.channels, channel)) image = Picture(view.width, view.height);
  };
  Frame frame;
  give_all(frame.colour);
  if constexpr (std::is_same_v<Real, double>) give_all(frame.colour_double);
  if (has(request.channels, Channel::ids)) give_all(frame.ids);
  if (has(request.channels, Channel::shadow)) give_all(frame.shadow);
  give_size(frame.depth, Channel::depth);
  give_size(frame.normal, Channel::normal);
  give_size(frame.barycentric, Channel::barycentric);
  give_size(frame.uv, Channel::uv);
  give_size(frame.facing, Channel::facing);
  give_size(frame.overdraw, Channel::overdraw);
  give_size(frame.tests, Channel::tests);
  give_size(frame.mip, Channel::mip);
  give_size(frame.samples, Channel::samples);
  give_size(frame.direction, Channel::direction);
  give_size(frame.shadow_map, Channel::shadow_map);
  for (float& depth : frame.shadow_map.pixels()) depth = -1;  // no map here
  give_size(frame.stencil, Channel::stencil);
  give_size(frame.environment, Channel::environment);
  for (Vec3f& colour : frame.environment.pixels()) colour = Vec3f(-1);
  return frame;
}

}  // namespace ps
