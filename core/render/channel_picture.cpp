#include "render/channel_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "image/heat_colour.h"
#include "render/channel_value.h"
#include "render/precision_channels.h"

namespace ps {
namespace {

constexpr Rgb8 nothing_seen{0, 0, 0};
constexpr Rgb8 white{255, 255, 255};
constexpr Rgb8 magenta{255, 0, 255};
constexpr Rgb8 orange{255, 140, 0};
constexpr Rgb8 front_blue{38, 102, 178};
constexpr Rgb8 back_orange{214, 110, 20};
constexpr Rgb8 edge_on{236, 232, 224};

/// colour(x, y) for each pixel.
template <class Colour>
Image<Rgb8> paint(const Frame& frame, Colour colour) {
  Image<Rgb8> picture(frame.width(), frame.height());
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) picture.row(y)[static_cast<std::size_t>(x)] = colour(x, y);
  return picture;
}

ChannelLegend keys(std::vector<ChannelLegend::Entry> entries) {
  ChannelLegend legend;
  legend.entries = std::move(entries);
  return legend;
}

/// Numbers in [0, 1] as levels; NaN gives 0.
Rgb8 unit_levels(double r, double g, double b) { return display_pixel({r, g, b}, {}); }

/// Where a number that is counted starts at 0, so should its range; a single value still gives a range.
ValueRange widened(ValueRange range, ShownChannel channel) {
  const bool is_depth = channel == ShownChannel::depth || channel == ShownChannel::shadow_map;
  if (!is_depth) range.low = std::min(range.low, 0.0);
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

ChannelPicture heat_picture(const Frame& frame, ShownChannel channel, const std::optional<ValueRange>& asked) {
  const ValueRange range = asked ? *asked : widened(channel_range(frame, channel).value_or(ValueRange{}), channel);
  const double length = range.high > range.low ? range.high - range.low : 1;
  ChannelPicture result;
  result.levels = paint(frame, [&](int x, int y) {
    const auto value = heat_value(frame, channel, x, y);
    return value ? heat_colour((*value - range.low) / length) : nothing_seen;
  });
  result.legend.heat = true;
  result.legend.low = range.low;
  result.legend.high = range.high;
  if (channel == ShownChannel::mip) result.legend.entries = {{nothing_seen, "no texture read"}};
  if (channel == ShownChannel::depth || channel == ShownChannel::shadow)
    result.legend.entries = {{nothing_seen, "nothing seen"}};
  if (channel == ShownChannel::shadow_map) result.legend.entries = {{nothing_seen, "no surface, or no map"}};
  return result;
}

Rgb8 mixed(Rgb8 a, Rgb8 b, double f) {
  const auto level = [f](std::uint8_t p, std::uint8_t q) {
    return static_cast<std::uint8_t>(std::lround(p + (q - p) * f));
  };
  return {level(a.r, b.r), level(a.g, b.g), level(a.b, b.b)};
}

ChannelPicture facing_picture(const Frame& frame) {
  const auto levels = paint(frame, [&](int x, int y) {
    const double cosine = frame.facing.at(x, y);
    if (cosine == 0 || std::isnan(cosine)) return nothing_seen;
    return mixed(edge_on, cosine > 0 ? front_blue : back_orange, std::min(std::abs(cosine), 1.0));
  });
  return {levels,
          keys({{front_blue, "front"}, {edge_on, "edge-on"}, {back_orange, "back"}, {nothing_seen, "nothing seen"}})};
}

ChannelPicture id_picture(const Frame& frame, ShownChannel channel) {
  const auto levels = paint(frame, [&](int x, int y) {
    const PixelId id = frame.ids.at(x, y);
    if (id.object < 0) return nothing_seen;
    const auto object = static_cast<std::uint32_t>(id.object);
    // A large odd step keeps the triangles of neighbouring objects apart.
    constexpr std::uint32_t object_step = 7919;
    return id_colour(channel == ShownChannel::object ? object
                                                     : object * object_step + static_cast<std::uint32_t>(id.triangle));
  });
  ChannelLegend legend = keys({{nothing_seen, "nothing seen"}});
  if (channel == ShownChannel::object) {
    constexpr int most_entries = 16;
    std::vector<bool> seen(most_entries, false);
    for (const PixelId& id : frame.ids.pixels())
      if (id.object >= 0 && id.object < most_entries) seen[static_cast<std::size_t>(id.object)] = true;
    for (std::uint32_t i = 0; i < most_entries; ++i)
      if (seen[i]) legend.entries.push_back({id_colour(i), "object " + std::to_string(i), static_cast<int>(i)});
  }
  return {levels, legend};
}

ChannelPicture nan_picture(const Frame& frame, const Settings& settings) {
  const DisplayTransform transform = display_transform(settings);
  const auto levels = paint(frame, [&](int x, int y) {
    const Vec3d c = linear_at(frame, {x, y});
    if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) return magenta;
    if (std::isinf(c.r) || std::isinf(c.g) || std::isinf(c.b)) return orange;
    const Rgb8 shown = display_pixel(c, transform);
    const auto dim = static_cast<std::uint8_t>((shown.r + shown.g + shown.b) / 9);
    return Rgb8{dim, dim, dim};
  });
  return {levels, keys({{magenta, "not a number"}, {orange, "infinite"}})};
}

/// A fault is one pixel among thousands: its colour stands out against the picture in dark grey, and its number is
/// shown.
ChannelPicture precision_picture(const Frame& frame, const Settings& settings) {
  const DisplayTransform transform = display_transform(settings);
  std::array<std::size_t, precision_fault_count> counts{};
  const auto levels = paint(frame, [&](int x, int y) {
    const PrecisionFault fault = frame.precision.at(x, y);
    ++counts[static_cast<std::size_t>(fault)];
    if (fault != PrecisionFault::none) return precision_fault_colour(fault);
    const Rgb8 shown = display_pixel(linear_at(frame, {x, y}), transform);
    const auto dim = static_cast<std::uint8_t>((shown.r + shown.g + shown.b) / 9);
    return Rgb8{dim, dim, dim};
  });
  ChannelLegend legend;
  for (std::size_t i = 1; i <= precision_fault_count; ++i) {
    const auto fault = static_cast<PrecisionFault>(i % precision_fault_count);  // "as in double" comes last
    legend.entries.push_back({precision_fault_colour(fault), fmt::format("{}: {} px", precision_fault_label(fault),
                                                                         counts[static_cast<std::size_t>(fault)])});
  }
  return {levels, legend};
}

ChannelPicture depth_gap_picture(const Frame& frame) {
  ChannelPicture result;
  std::size_t confused = 0;
  result.levels = paint(frame, [&](int x, int y) {
    const float gap = frame.depth_gap.at(x, y);
    confused += gap < 1 ? 1 : 0;
    return depth_gap_colour(gap);
  });
  result.legend = keys({{depth_gap_colour(0), fmt::format("below 1, the same depth: {} px", confused)},
                        {depth_gap_colour(std::numeric_limits<float>::infinity()), "no second surface"}});
  result.legend.heat = true;
  result.legend.low = 1;
  result.legend.high = most_depth_gap;
  return result;
}

/// Unit vectors: (x, y, z) from -1 to 1 as red, green, blue (CGPP 15.4.1.2).
ChannelPicture vector_picture(const Frame& frame, const Image<Vec3f>& vectors) {
  return {
      paint(frame,
            [&](int x, int y) {
              const Vec3f n = vectors.at(x, y);
              if (n == Vec3f(0)) return nothing_seen;
              return unit_levels((n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2);
            }),
      keys(
          {{{255, 128, 128}, "+x"}, {{128, 255, 128}, "+y"}, {{128, 128, 255}, "+z"}, {nothing_seen, "nothing seen"}})};
}

ChannelPicture make_picture(const Frame& frame, ShownChannel channel, const Settings& settings,
                            const std::optional<ValueRange>& range) {
  switch (channel) {
  case ShownChannel::colour:
    return {display_frame(frame, settings), {}};
  case ShownChannel::depth:
  case ShownChannel::overdraw:
  case ShownChannel::tests:
  case ShownChannel::mip:
  case ShownChannel::samples:
  case ShownChannel::shadow:
  case ShownChannel::shadow_map:
  case ShownChannel::stencil:
    return heat_picture(frame, channel, range);
  case ShownChannel::normal:
    return vector_picture(frame, frame.normal);
  case ShownChannel::direction:
    return vector_picture(frame, frame.direction);
  case ShownChannel::barycentric:
    return {paint(frame,
                  [&](int x, int y) {
                    const Vec3f w = frame.barycentric.at(x, y);
                    return unit_levels(w.x, w.y, w.z);
                  }),
            keys({{{255, 0, 0}, "vertex 0"}, {{0, 255, 0}, "vertex 1"}, {{0, 0, 255}, "vertex 2"}})};
  case ShownChannel::uv:
    return {paint(frame,
                  [&](int x, int y) {
                    const Vec2f uv = frame.uv.at(x, y);
                    return unit_levels(uv.x - std::floor(uv.x), uv.y - std::floor(uv.y), 0);
                  }),
            keys({{{255, 0, 0}, "u"}, {{0, 255, 0}, "v"}})};
  case ShownChannel::triangle:
  case ShownChannel::object:
    return id_picture(frame, channel);
  case ShownChannel::facing:
    return facing_picture(frame);
  case ShownChannel::hit:
    return {paint(frame, [&](int x, int y) { return frame.ids.at(x, y).object < 0 ? nothing_seen : white; }),
            keys({{white, "something seen"}, {nothing_seen, "nothing seen"}})};
  case ShownChannel::environment:
    return {paint(frame,
                  [&](int x, int y) {
                    const Vec3f c = frame.environment.at(x, y);
                    return c.x < 0 ? nothing_seen : display_pixel(Vec3d(c), display_transform(settings));
                  }),
            keys({{nothing_seen, "no map here"}})};
  case ShownChannel::nan:
    return nan_picture(frame, settings);
  case ShownChannel::precision:
    return precision_picture(frame, settings);
  case ShownChannel::depth_gap:
    return depth_gap_picture(frame);
  }
  return {};
}

/// A light's map may reach far beyond the objects that cast shadows: colours end at a few times the usual depth.
ValueRange shadow_map_range(ValueRange range, const Frame& frame) {
  constexpr double most = 3;
  std::vector<float> depths;
  for (const float depth : frame.shadow_map.pixels())
    if (depth >= 0 && std::isfinite(depth)) depths.push_back(depth);
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  range.high = std::min(range.high, most * *middle);
  return range;
}

}  // namespace

std::optional<ValueRange> channel_range(const Frame& frame, ShownChannel channel) {
  if (!is_heat_map(channel)) return {};
  std::optional<ValueRange> range;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const auto value = heat_value(frame, channel, x, y);
      if (!value) continue;
      if (!range) range = ValueRange{*value, *value};
      range->low = std::min(range->low, *value);
      range->high = std::max(range->high, *value);
    }
  }
  if (range && channel == ShownChannel::shadow_map) return shadow_map_range(*range, frame);
  return range;
}

ChannelPicture channel_picture(const Frame& frame, ShownChannel channel, const Settings& settings,
                               const std::optional<ValueRange>& range) {
  const ShownChannelRow& row = shown_channel(channel);
  ChannelPicture result = make_picture(frame, channel, settings, range);
  result.legend.title = row.label;
  result.legend.unit = row.unit;
  return result;
}

}  // namespace ps
