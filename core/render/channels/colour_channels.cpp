#include <fmt/format.h>

#include "frame/display_frame.h"
#include "math/has_nan.h"
#include "render/channels/channels.h"

/// Channels whose pixels are colours of the picture or of a map.

namespace ps::channels {
namespace {

constexpr Rgb8 magenta{255, 0, 255};
constexpr Rgb8 orange{255, 140, 0};

enum class ColourKind { finite, nan, infinite };

ColourKind kind_of_colour(const Vec3d& c) {
  if (has_nan(c)) return ColourKind::nan;
  return is_finite(c) ? ColourKind::finite : ColourKind::infinite;
}

ChannelPicture nan_picture(const Frame& frame, const Settings& settings) {
  const DisplayTransform transform = display_transform(settings);
  const auto levels = paint(frame, [&](int x, int y) {
    const Vec3d c = linear_at(frame, {x, y});
    switch (kind_of_colour(c)) {
    case ColourKind::nan:
      return magenta;
    case ColourKind::infinite:
      return orange;
    case ColourKind::finite:
      break;
    }
    return dimmed(display_pixel(c, transform));
  });
  return {levels, legend_of({{magenta, "not a number"}, {orange, "infinite"}})};
}

ChannelPicture environment_picture(const Frame& frame, const Settings& settings) {
  return {paint(frame,
                [&](int x, int y) {
                  const Vec3f c = frame.environment.at(x, y);
                  return c.x < 0 ? nothing_seen : display_pixel(Vec3d(c), display_transform(settings));
                }),
          legend_of({{nothing_seen, "no map here"}})};
}

}  // namespace

const ShownChannelRow colour_channel{.channel = ShownChannel::colour,
                                     .key = "colour",
                                     .label = "Colour",
                                     .help = "The picture itself.",
                                     .unit = "",
                                     .text =
                                         [](const Frame& frame, const Settings& settings, Vec2i pixel) {
                                           const Rgb8 c = display_at(frame, settings, pixel);
                                           return fmt::format("{} {} {}", c.r, c.g, c.b);
                                         },
                                     .picture = [](const Frame& frame, const Settings& settings) -> ChannelPicture {
                                       return {display_frame(frame, settings), {}};
                                     },
                                     .floats = [](const Frame& frame) -> ChannelFloats { return frame.colour; }};

const ShownChannelRow nan_channel{
    .channel = ShownChannel::nan,
    .key = "nan",
    .label = "NaN",
    .help = "Magenta where a colour is not a number, orange where it is infinite.",
    .unit = "",
    .text = [](const Frame& frame, const Settings&, Vec2i pixel) { return triple(linear_at(frame, pixel)); },
    .picture = nan_picture,
    .floats = [](const Frame& frame) -> ChannelFloats {
      return number_image(frame, [&](int x, int y) {
        return static_cast<int>(kind_of_colour(linear_at(frame, {x, y})));
      });
    }};

const ShownChannelRow environment_channel{
    .channel = ShownChannel::environment,
    .key = "environment",
    .label = "Environment map",
    .help = "The cube map of the first reflective object, unfolded.",
    .needs = Channel::environment,
    .unit = "",
    .text =
        [](const Frame& frame, const Settings&, Vec2i pixel) {
          const Vec3f c = frame.environment.at(pixel.x, pixel.y);
          return c.x < 0 ? "no map here" : triple(Vec3d(c));
        },
    .picture = environment_picture,
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.environment; }};

}  // namespace ps::channels
