#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "render/channels/channels.h"

/// Channels of directions, weights and texture coordinates.

namespace ps::channels {
namespace {

constexpr Rgb8 front_blue{38, 102, 178};
constexpr Rgb8 back_orange{214, 110, 20};
constexpr Rgb8 edge_on{236, 232, 224};

/// Unit vectors: (x, y, z) from -1 to 1 as red, green, blue (CGPP 15.4.1.2).
ChannelPicture vector_picture(const Frame& frame, const Image<Vec3f>& vectors) {
  return {
      paint(frame,
            [&](int x, int y) {
              const Vec3f n = vectors.at(x, y);
              if (n == Vec3f(0)) return nothing_seen;
              return unit_levels((n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2);
            }),
      legend_of(
          {{{255, 128, 128}, "+x"}, {{128, 255, 128}, "+y"}, {{128, 128, 255}, "+z"}, {nothing_seen, "nothing seen"}})};
}

ChannelPicture weights_picture(const Frame& frame, const Settings&) {
  return {paint(frame,
                [&](int x, int y) {
                  const Vec3f w = frame.barycentric.at(x, y);
                  return unit_levels(w.x, w.y, w.z);
                }),
          legend_of({{{255, 0, 0}, "vertex 0"}, {{0, 255, 0}, "vertex 1"}, {{0, 0, 255}, "vertex 2"}})};
}

ChannelPicture uv_picture(const Frame& frame, const Settings&) {
  return {paint(frame,
                [&](int x, int y) {
                  const Vec2f at = frame.uv.at(x, y);
                  return unit_levels(at.x - std::floor(at.x), at.y - std::floor(at.y), 0);
                }),
          legend_of({{{255, 0, 0}, "u"}, {{0, 255, 0}, "v"}})};
}

ChannelFloats uv_floats(const Frame& frame) {
  Image<Vec3f> image(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) image.at(x, y) = {frame.uv.at(x, y).x, frame.uv.at(x, y).y, 0};
  return image;
}

Rgb8 mixed(Rgb8 a, Rgb8 b, double f) {
  const auto level = [f](std::uint8_t p, std::uint8_t q) {
    return static_cast<std::uint8_t>(std::lround(p + (q - p) * f));
  };
  return {level(a.r, b.r), level(a.g, b.g), level(a.b, b.b)};
}

ChannelPicture facing_picture(const Frame& frame, const Settings&) {
  const auto levels = paint(frame, [&](int x, int y) {
    const double cosine = frame.facing.at(x, y);
    if (cosine == 0 || std::isnan(cosine)) return nothing_seen;
    return mixed(edge_on, cosine > 0 ? front_blue : back_orange, std::min(std::abs(cosine), 1.0));
  });
  return {
      levels,
      legend_of({{front_blue, "front"}, {edge_on, "edge-on"}, {back_orange, "back"}, {nothing_seen, "nothing seen"}})};
}

}  // namespace

const ShownChannelRow normal_channel{
    .channel = ShownChannel::normal,
    .key = "normal",
    .label = "Normal",
    .help = "Shading normal: x, y, z from -1 to 1 as red, green, blue.",
    .needs = Channel::normal,
    .unit = "",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return triple(Vec3d(frame.normal.at(pixel.x, pixel.y))); },
    .picture = [](const Frame& frame, const Settings&) { return vector_picture(frame, frame.normal); },
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.normal; }};

const ShownChannelRow direction_channel{
    .channel = ShownChannel::direction,
    .key = "direction",
    .label = "Eye rays",
    .help = "Direction of the eye ray: x, y, z from -1 to 1 as red, green, blue.",
    .needs = Channel::direction,
    .unit = "",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return triple(Vec3d(frame.direction.at(pixel.x, pixel.y))); },
    .picture = [](const Frame& frame, const Settings&) { return vector_picture(frame, frame.direction); },
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.direction; }};

const ShownChannelRow barycentric_channel{
    .channel = ShownChannel::barycentric,
    .key = "barycentric",
    .label = "Barycentric",
    .help = "Weights of the triangle's vertices as red, green, blue.",
    .needs = Channel::barycentric,
    .unit = "",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return triple(Vec3d(frame.barycentric.at(pixel.x, pixel.y))); },
    .picture = weights_picture,
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.barycentric; }};

const ShownChannelRow uv_channel{.channel = ShownChannel::uv,
                                 .key = "uv",
                                 .label = "Texture coordinates",
                                 .help = "Fractional parts of u and v as red and green.",
                                 .needs = Channel::uv,
                                 .unit = "",
                                 .text =
                                     [](const Frame& frame, const Settings&, Vec2i pixel) {
                                       const Vec2f at = frame.uv.at(pixel.x, pixel.y);
                                       return fmt::format("({:.4g}, {:.4g})", at.x, at.y);
                                     },
                                 .picture = uv_picture,
                                 .floats = uv_floats};

const ShownChannelRow facing_channel{
    .channel = ShownChannel::facing,
    .key = "facing",
    .label = "Facing",
    .help = "Blue: front side. Orange: back side. Pale: seen edge-on.",
    .needs = Channel::facing,
    .unit = "",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return fmt::format("{:.4g}", frame.facing.at(pixel.x, pixel.y)); },
    .picture = facing_picture,
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.facing; }};

}  // namespace ps::channels
