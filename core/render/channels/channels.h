#pragma once
#include <utility>

#include "render/channel_picture.h"

/// The rows of the shown channels, each with its functions, and what several of them share. channel_table.cpp puts them
/// in order.

namespace ps::channels {

extern const ShownChannelRow colour_channel, nan_channel, environment_channel;
extern const ShownChannelRow depth_channel, overdraw_channel, tests_channel, mip_channel, samples_channel,
    shadow_channel, shadow_map_channel, stencil_channel;
extern const ShownChannelRow normal_channel, direction_channel, barycentric_channel, uv_channel, facing_channel;
extern const ShownChannelRow triangle_channel, object_channel, hit_channel;
extern const ShownChannelRow precision_channel, depth_gap_channel;
extern const ShownChannelRow field_channel;

inline constexpr Rgb8 nothing_seen{0, 0, 0};

/// "(0, 0.5, 1)"
std::string triple(const Vec3d& v);

/// Numbers in [0, 1] as levels; NaN gives 0.
Rgb8 unit_levels(double r, double g, double b);

/// The colour of a pixel as a dark grey, against which colours with a meaning stand out.
Rgb8 dimmed(Rgb8 shown);

/// colour(x, y) for each pixel.
template <class Colour>
Image<Rgb8> paint(const Frame& frame, Colour colour) {
  Image<Rgb8> picture(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) picture.row(y)[static_cast<std::size_t>(x)] = colour(x, y);
  return picture;
}

/// value(x, y) for each pixel.
template <class Value>
Image<float> number_image(const Frame& frame, Value value) {
  Image<float> image(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) image.row(y)[static_cast<std::size_t>(x)] = static_cast<float>(value(x, y));
  return image;
}

/// A legend of colours that each mean something.
ChannelLegend legend_of(std::vector<ChannelLegend::Entry> entries);

}  // namespace ps::channels
