#include <fmt/format.h>

#include "image/heat_colour.h"
#include "render/channels/channels.h"

/// Channels of what the pixel shows.

namespace ps::channels {
namespace {

constexpr Rgb8 white{255, 255, 255};

std::string object_text(const Frame& frame, const Settings&, Vec2i pixel) {
  const PixelId id = frame.ids.at(pixel.x, pixel.y);
  return id.object < 0 ? "nothing" : fmt::format("object {}", id.object);
}

std::string triangle_text(const Frame& frame, const Settings&, Vec2i pixel) {
  const PixelId id = frame.ids.at(pixel.x, pixel.y);
  return id.object < 0 ? "nothing" : fmt::format("object {}, triangle {}", id.object, id.triangle);
}

/// One colour for each number; `number` gets ids of objects alone.
template <class Number>
Image<Rgb8> paint_ids(const Frame& frame, Number number) {
  return paint(frame, [&](int x, int y) {
    const PixelId id = frame.ids.at(x, y);
    return id.object < 0 ? nothing_seen : id_colour(number(id));
  });
}

ChannelPicture triangle_picture(const Frame& frame, const Settings&) {
  // A large odd step keeps the triangles of neighbouring objects apart.
  constexpr std::uint32_t object_step = 7919;
  return {paint_ids(frame,
                    [](const PixelId& id) {
                      return static_cast<std::uint32_t>(id.object) * object_step +
                             static_cast<std::uint32_t>(id.triangle);
                    }),
          legend_of({{nothing_seen, "nothing seen"}})};
}

ChannelPicture object_picture(const Frame& frame, const Settings&) {
  ChannelPicture result{paint_ids(frame, [](const PixelId& id) { return static_cast<std::uint32_t>(id.object); }),
                        legend_of({{nothing_seen, "nothing seen"}})};
  constexpr int most_entries = 16;
  std::vector<bool> seen(most_entries, false);
  for (const PixelId& id : frame.ids.pixels())
    if (id.object >= 0 && id.object < most_entries) seen[static_cast<std::size_t>(id.object)] = true;
  for (std::uint32_t i = 0; i < most_entries; ++i)
    if (seen[i]) result.legend.entries.push_back({id_colour(i), "object " + std::to_string(i), static_cast<int>(i)});
  return result;
}

}  // namespace

const ShownChannelRow triangle_channel{.channel = ShownChannel::triangle,
                                       .key = "triangle",
                                       .label = "Triangle",
                                       .help = "One colour for each triangle.",
                                       .needs = Channel::ids,
                                       .unit = "",
                                       .text = triangle_text,
                                       .picture = triangle_picture,
                                       .floats = [](const Frame& frame) -> ChannelFloats {
                                         return number_image(frame,
                                                             [&](int x, int y) { return frame.ids.at(x, y).triangle; });
                                       }};

const ShownChannelRow object_channel{.channel = ShownChannel::object,
                                     .key = "object",
                                     .label = "Object",
                                     .help = "One colour for each object.",
                                     .needs = Channel::ids,
                                     .unit = "",
                                     .text = object_text,
                                     .picture = object_picture,
                                     .floats = [](const Frame& frame) -> ChannelFloats {
                                       return number_image(frame,
                                                           [&](int x, int y) { return frame.ids.at(x, y).object; });
                                     }};

const ShownChannelRow hit_channel{
    .channel = ShownChannel::hit,
    .key = "hit",
    .label = "Hit",
    .help = "White where the pixel shows an object.",
    .needs = Channel::ids,
    .unit = "",
    .text = object_text,
    .picture = [](const Frame& frame, const Settings&) -> ChannelPicture {
      return {paint(frame, [&](int x, int y) { return frame.ids.at(x, y).object < 0 ? nothing_seen : white; }),
              legend_of({{white, "something seen"}, {nothing_seen, "nothing seen"}})};
    },
    .floats = [](const Frame& frame) -> ChannelFloats {
      return number_image(frame, [&](int x, int y) { return frame.ids.at(x, y).object < 0 ? 0 : 1; });
    }};

}  // namespace ps::channels
