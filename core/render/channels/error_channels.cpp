#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "render/channels/channels.h"
#include "render/precision_channels.h"

/// Channels of rounding errors and of what they may confuse.

namespace ps::channels {
namespace {

/// A fault is one pixel among thousands: its colour stands out against the picture in dark grey, and its number is
/// shown.
ChannelPicture precision_picture(const Frame& frame, const Settings& settings) {
  const DisplayTransform transform = display_transform(settings);
  std::array<std::size_t, precision_fault_count> counts{};
  const auto levels = paint(frame, [&](int x, int y) {
    const PrecisionFault fault = frame.precision.at(x, y);
    ++counts[static_cast<std::size_t>(fault)];
    if (fault != PrecisionFault::none) return precision_fault_colour(fault);
    return dimmed(display_pixel(linear_at(frame, {x, y}), transform));
  });
  ChannelLegend legend;
  for (std::size_t i = 1; i <= precision_fault_count; ++i) {
    const auto fault = static_cast<PrecisionFault>(i % precision_fault_count);  // "as in double" comes last
    legend.entries.push_back({precision_fault_colour(fault), fmt::format("{}: {} px", precision_fault_label(fault),
                                                                         counts[static_cast<std::size_t>(fault)])});
  }
  return {levels, legend};
}

ChannelPicture depth_gap_picture(const Frame& frame, const Settings&) {
  ChannelPicture result;
  std::size_t confused = 0;
  result.levels = paint(frame, [&](int x, int y) {
    const float gap = frame.depth_gap.at(x, y);
    confused += gap < 1 ? 1 : 0;
    return depth_gap_colour(gap);
  });
  result.legend = legend_of({{depth_gap_colour(0), fmt::format("below 1, the same depth: {} px", confused)},
                             {depth_gap_colour(std::numeric_limits<float>::infinity()), "no second surface"}});
  result.legend.heat = true;
  result.legend.low = 1;
  result.legend.high = most_depth_gap;
  return result;
}

}  // namespace

const ShownChannelRow precision_channel{
    .channel = ShownChannel::precision,
    .key = "precision",
    .label = "Precision",
    .help =
        "The picture compared with a rendering in double: pixels that differ, by kind of error. The rest is dimmed.",
    .needs = Channel::precision | Channel::ids,
    .unit = "",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return std::string(precision_fault_label(frame.precision.at(pixel.x, pixel.y))); },
    .picture = precision_picture,
    .floats = [](const Frame& frame) -> ChannelFloats {
      return number_image(frame, [&](int x, int y) { return static_cast<int>(frame.precision.at(x, y)); });
    }};

const ShownChannelRow depth_gap_channel{
    .channel = ShownChannel::depth_gap,
    .key = "depth-gap",
    .label = "Depth gap",
    .help = "Gap between the first and the second surface, in units in the last place (ulp) of the stored depth.",
    .needs = Channel::depth_gap,
    .unit = "ulp of stored depth (log scale)",
    .text =
        [](const Frame& frame, const Settings&, Vec2i pixel) {
          const float gap = frame.depth_gap.at(pixel.x, pixel.y);
          if (std::isinf(gap)) return std::string("no second surface");
          return fmt::format("second surface {:.4g} ulp behind", gap);
        },
    .picture = depth_gap_picture,
    .floats = [](const Frame& frame) -> ChannelFloats { return frame.depth_gap; }};

}  // namespace ps::channels
